// The hooks of effects: what each adds to, in the order in which they are asked.
//
//   conditions(p, at, Conditions<T>& sum)          gravity and masses, before anything is weighed
//   wrench(p, at, Wrench<T>& sum)                  forces on the platform
//   transverse_force(p, at, StrutVectors<T>& sum)  force on the platform at each platform joint, N in W
//   nut_tension(p, at, PerStrut<T>& sum)           tension of the nut beyond the platform joint's, N
//   drive_tension(p, at, PerStrut<T>& sum)         drive's pull beyond the nut's tension, N (reads nut_tension)
//   length(p, at, PerStrut<T>& sum)                length that the controller does not know of, m (reads drive_tension)
//   tip(p, at, Vector6<T>& sum)                    displacement of the tip that no strut makes, m and rad in W
//   reading(p, at, PerStrut<T>& sum)               what the torque reading adds, N m (reads torque)
//
// `p` are the parameters in SI, `at` the machine at that moment (physics/situation.hpp).
#pragma once

#include "physics/effect_info.hpp"
#include "physics/force_model.hpp"

/// The list: DO(hook, type of its sum for a scalar T). Whoever needs all hooks goes through it: the asking below, and
/// the derivatives of src/identify, which do not compile until they know what a new sum does to the outcome.
#define PLUMBLINE_HOOKS(DO)                      \
  DO(conditions, Conditions<T>)                  \
  DO(wrench, Wrench<T>)                          \
  DO(transverse_force, machine::StrutVectors<T>) \
  DO(nut_tension, machine::PerStrut<T>)          \
  DO(drive_tension, machine::PerStrut<T>)        \
  DO(length, machine::PerStrut<T>)               \
  DO(tip, machine::Vector6<T>)                   \
  DO(reading, machine::PerStrut<T>)

namespace plumbline::physics {

/// Calls apply(Effect, parameters) for each instance of each effect.
template <class T, class Apply>
void for_each_instance(const ForceModel& model, const Parameter<T>* parameters, Apply&& apply) {
  const auto each = [&]<class Effect>(std::size_t i) {
    for (const int first : model.instances_of(i)) apply.template operator()<Effect>(Values<T>(parameters + first));
  };
  for_each_effect<0, kBaseEffects>(each);
  if (model.has_catalogue_effects()) for_each_effect<kBaseEffects, kEffects>(each);
}

// One function per hook: asks every instance of every effect that has the hook. The name alone decides, so that a hook
// whose arguments are wrong does not compile.
// NOLINTBEGIN(bugprone-macro-parentheses): the name of a member takes none
#define PLUMBLINE_ASK(hook, Sum)                                                                               \
  template <class T>                                                                                           \
  void ask_##hook(const ForceModel& model, const Parameter<T>* parameters, const Situation<T>& at, Sum& sum) { \
    for_each_instance<T>(model, parameters, [&]<class Effect>(Values<T> p) {                                   \
      if constexpr (requires { &Effect::template hook<T>; }) Effect::hook(p, at, sum);                         \
    });                                                                                                        \
  }
// NOLINTEND(bugprone-macro-parentheses)
PLUMBLINE_HOOKS(PLUMBLINE_ASK)
#undef PLUMBLINE_ASK

}  // namespace plumbline::physics
