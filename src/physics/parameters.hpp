// Parameters of effects: what each is called in files, its unit and its bounds, and how an effect reads them.
#pragma once

#include <string_view>
#include <type_traits>

#include "base/scalar.hpp"
#include "machine/model_keys.hpp"
#include "machine/unit.hpp"

namespace plumbline::physics {

/// One key of an effect. Bounds are inclusive, in the file's unit; `lower` is zero for what cannot be negative.
struct ParameterSpec {
  std::string_view key;
  machine::Unit unit;
  int count = 1;  // how many numbers: 1, 2, 3, 6
  double lower = 0;
  double upper = 0;
  int each = 1;                       // 3: an array of `count` points, 3 x count numbers
  double initial = 0;                 // in a fresh instance; the instance as a whole shall change nothing with it
  std::string_view table = {};        // base effects: the table of the model file that holds the key
  bool optional = false;              // a row may leave the key out: it then has its initial value
  bool setting = false;               // says what the effect is, and is never fitted
  bool whole = false;                 // whole numbers only
  bool shared = false;                // by all struts: one unknown moves all six in proportion
  bool shape = false;                 // bends what the others add, and adds nothing itself: a phase, a speed
  bool periodic = false;              // a whole turn more is the same
  std::string_view uncertainty = {};  // key of [uncertainty] that says how well it is known
  std::string_view label = {};        // what people call it; none: effect and key

  constexpr int size() const { return count * each; }
};

/// What an effect says of a key of the model file; see ParameterSpec.
struct KeyTraits {
  bool shared = false;
  std::string_view uncertainty = {};
  std::string_view label = {};
};

/// The parameter that stands under a key of the model file itself: unit and range as machine/model_keys.hpp has them.
constexpr ParameterSpec model_key(std::string_view table, std::string_view key, const KeyTraits& traits = {}) {
  const machine::KeySpec& spec = machine::key_spec(table, key);
  return {.key = spec.key,
          .unit = spec.unit,
          .count = static_cast<int>(machine::count_of(spec.shape)),
          .lower = spec.lower,
          .upper = spec.upper,
          .table = spec.table,
          .shared = traits.shared,
          .uncertainty = traits.uncertainty,
          .label = traits.label};
}

/// What the parameters are stored as for a calculation in T: lanes share them.
template <class T>
using Parameter = std::conditional_t<kIsPack<T>, double, T>;

/// The parameters of one instance of an effect, one after the other as its table lists them, in SI.
template <class T>
class Values {
 public:
  explicit Values(const Parameter<T>* first) : first_(first) {}
  std::conditional_t<kIsPack<T>, T, const T&> operator[](int i) const { return first_[i]; }
  /// A setting that is a whole number: all lanes have it alike, and nothing is derived by it.
  int whole(int i) const {
    if constexpr (requires { first_[i].a; }) {
      return static_cast<int>(first_[i].a);
    } else {
      return static_cast<int>(first_[i]);
    }
  }
  /// Whether none of so many parameters does anything, not even by its derivative.
  bool idle(int first, int count) const {
    if constexpr (std::is_same_v<Parameter<T>, double>) {
      for (int i = first; i < first + count; ++i) {
        if (first_[i] != 0) return false;
      }
      return true;
    } else {
      return false;
    }
  }

 private:
  const Parameter<T>* first_;
};

}  // namespace plumbline::physics
