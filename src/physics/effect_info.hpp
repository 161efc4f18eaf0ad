// The list of effects as a table that can be looked through at run time.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "physics/bend.hpp"
#include "physics/effects/list.hpp"

namespace plumbline::physics {

/// Whether the numbers of an effect, all of them given for each strut, move the length of their own strut and nothing
/// else, whatever the loads: such an effect says so by `own_strut_alone`.
template <class Effect>
inline constexpr bool moves_own_strut_alone = requires {
  Effect::own_strut_alone;
};

struct EffectInfo {
  std::string_view name;
  std::span<const ParameterSpec> parameters;
  bool base = false;  // always there

  // what an effect says of itself by a member of that name
  bool own_strut_alone = false;  // see moves_own_strut_alone
  bool dynamic = false;          // follows from accelerations or from the control's following: it depends on how the
                                 // control shapes the speed
  bool rare = false;             // less common than the others of the catalogue
  bool suspect = false;          // much that no catalogue has looks like it: found, it is suspected and not named
  bool sums_to_zero = false;     // its numbers do, all of them together
  bool geometry = false;         // where joints are and how long struts are, other than the controller believes
  bool path = false;             // it moves the tip by what it does to lengths and joints, whatever the forces are
  bool friction = false;         // it holds against motion: forces and tips differ by the direction of the way
  bool description = false;      // no cause: nobody looks for it
  const Bend* bend = nullptr;    // none: readings move in proportion to its numbers

  bool reading_alone = false;  // it shows in the torque readings and nowhere else

  /// Whether it may be what a machine has and a model lacks.
  bool is_cause() const { return !base && !description; }
  /// How many numbers an instance has.
  int size() const;
  /// Where the numbers of a key begin; -1 if there is no such key.
  int offset_of(std::string_view key) const;
  /// The strut that a number of an instance belongs to, of keys that have some for each strut.
  int strut_of(int offset) const;
};

/// All effects, in the order of the list.
const std::array<EffectInfo, kEffects>& effect_infos();

/// The place of an effect in the list; kEffects if there is none of that name.
std::size_t effect_index(std::string_view name);

/// The names of the effects that a model file may name.
std::vector<std::string_view> catalogue_names();

/// Those of them that are causes, no descriptions.
std::vector<std::string_view> cause_names();

/// Calls apply.template operator()<Effect>(index) for each effect of the list from one to another, at compile time.
template <std::size_t kFrom = 0, std::size_t kTo = kEffects, class Apply>
void for_each_effect(Apply&& apply) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (apply.template operator()<std::tuple_element_t<kFrom + I, Effects>>(kFrom + I), ...);
  }
  (std::make_index_sequence<kTo - kFrom>{});
}

}  // namespace plumbline::physics
