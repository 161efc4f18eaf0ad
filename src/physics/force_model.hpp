// A machine model made ready for calculation: which effects act, and their parameters in one flat vector.
#pragma once

#include <array>
#include <vector>

#include "machine/model.hpp"
#include "physics/effect_info.hpp"

namespace plumbline::physics {

/// One effect that acts, and where its numbers are.
struct Instance {
  std::size_t effect = 0;  // in the list of effects
  int first = 0;           // its first parameter in the flat vector
};

class ForceModel {
 public:
  /// The base effects with the parameters of the model's tables, and one instance for each [[effect]] row. Refuses a
  /// row with effect-unknown, effect-unknown-key, effect-missing-key, effect-wrong-size, effect-out-of-bounds or
  /// effect-not-whole, at its place.
  explicit ForceModel(const machine::MachineModel& model);

  MachineConstants machine;
  std::vector<double> parameters;  // of all instances, SI
  double sign_speed = 0;           // v0 that the model states, m/s

  const std::vector<Instance>& instances() const { return instances_; }
  /// Whether any effect acts besides the base effects.
  bool has_catalogue_effects() const { return instances_.size() > kBaseEffects; }
  /// First parameters of the instances of one effect.
  const std::vector<int>& instances_of(std::size_t effect) const { return by_effect_[effect]; }

  /// Adds an instance of that effect (a bug if there is none of that name), which changes nothing as yet; returns its
  /// first parameter.
  int add(std::string_view effect);
  /// Where the numbers of a key of an effect begin in `parameters`, in its first instance; -1 if none acts.
  int find(std::string_view effect, std::string_view key) const;
  /// Friction on, the model's v0, no loads besides the model's.
  Environment environment() const;

 private:
  int append(std::size_t effect);
  void add_base(const machine::MachineModel& model, std::size_t effect);
  void add_row(const machine::EffectRow& row);

  std::vector<Instance> instances_;
  std::array<std::vector<int>, kEffects> by_effect_;
};

/// The model's parameters for a calculation in T: a pack's lanes share them, what derivatives are taken by has its own.
template <class T>
std::vector<Parameter<T>> parameters_as(const ForceModel& model) {
  return {model.parameters.begin(), model.parameters.end()};
}

}  // namespace plumbline::physics
