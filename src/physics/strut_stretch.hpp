// The chain of the calculation: from where the machine stands and how it is asked to move to what each strut carries,
// how much longer it is than commanded, and what its motor pulls.
#pragma once

#include <numbers>

#include "machine/jacobian.hpp"
#include "machine/lu6.hpp"
#include "physics/force_model.hpp"

namespace plumbline::physics {

/// What the struts carry at a pose, and what it does to them.
template <class T>
struct StrutStretch {
  machine::StrutGeometry<T> struts;     // where the machine stands
  machine::Lu6<T> jacobian;             // factorised there; where it is singular() nothing below means anything
  machine::StrutVectors<T> transverse;  // N_j, force on the platform at its joints, N in W
  machine::PerStrut<T> tension;         // t_j of the platform joint, N, positive pulls
  machine::PerStrut<T> nut_tension;     // t_nut,j
  machine::PerStrut<T> drive_tension;   // t_nut,j + f_j
  machine::PerStrut<T> stretch;         // dL_j: what each strut is longer than commanded, m
  machine::Vector6<T> tip;              // displacement of the tip that no strut makes, m and rad in W
  machine::PerStrut<T> torque;          // of the motors, as read, N m
};

/// Calls apply(Effect, parameters) for each instance of each effect.
template <class T, class Apply>
void for_each_instance(const ForceModel& model, const T* parameters, Apply&& apply) {
  for_each_effect([&]<class Effect>(std::size_t i) {
    for (const int first : model.instances_of(i)) apply.template operator()<Effect>(Values<T>(parameters + first));
  });
}

// One function per hook: asks every instance of every effect that has the hook. The name alone decides, so that a hook
// whose arguments are wrong does not compile.
// NOLINTBEGIN(bugprone-macro-parentheses): the name of a member takes none
#define PLUMBLINE_ASK(hook)                                                                         \
  template <class T, class Sum>                                                                     \
  void ask_##hook(const ForceModel& model, const T* parameters, const Situation<T>& at, Sum& sum) { \
    for_each_instance<T>(model, parameters, [&]<class Effect>(Values<T> p) {                        \
      if constexpr (requires { &Effect::template hook<T>; }) Effect::hook(p, at, sum);              \
    });                                                                                             \
  }
// NOLINTEND(bugprone-macro-parentheses)
PLUMBLINE_ASK(conditions)
PLUMBLINE_ASK(wrench)
PLUMBLINE_ASK(transverse_force)
PLUMBLINE_ASK(nut_tension)
PLUMBLINE_ASK(drive_tension)
PLUMBLINE_ASK(length)
PLUMBLINE_ASK(tip)
PLUMBLINE_ASK(reading)
#undef PLUMBLINE_ASK

/// The calculation at `pose`, where the machine stands, for struts that move with `rates`, those of the commanded path.
/// `parameters` are the model's, or others in their place (parameters_as). No heap, no state: points may be computed in
/// any order.
template <class T>
StrutStretch<T> strut_stretch_at(const ForceModel& model, const T* parameters, const Environment& environment,
                                 const Motion<T>& motion, const StrutRates<T>& rates, const Pose<T>& pose,
                                 const machine::StrutGeometry<T>& struts) {
  Situation<T> at{model.machine, environment, motion, rates, pose, struts, {}};

  at.conditions.gravity = model.machine.gravity.template cast<T>();
  ask_conditions(model, parameters, at, at.conditions);

  Wrench<T> wrench;
  ask_wrench(model, parameters, at, wrench);

  // N += sum N_j,  M += sum b_j x N_j  [Ibaraki et al., Eq. 5]
  machine::StrutVectors<T> transverse = machine::StrutVectors<T>::Zero();
  ask_transverse_force(model, parameters, at, transverse);
  for (int j = 0; j < machine::kStruts; ++j) wrench.add(transverse.col(j), struts.arm.col(j));

  // J^T t = (N, M), t > 0 pulls  [Ibaraki et al., Eq. 4; docs/physics.md]
  const machine::Lu6<T> lu(machine::jacobian(struts));
  machine::Vector6<T> load;
  load << wrench.force, wrench.moment;
  const machine::PerStrut<T> tension = lu.solve_transposed(load);

  at.nut_tension = tension;
  ask_nut_tension(model, parameters, at, at.nut_tension);

  at.drive_tension = at.nut_tension;
  ask_drive_tension(model, parameters, at, at.drive_tension);

  machine::PerStrut<T> stretch = machine::PerStrut<T>::Zero();
  ask_length(model, parameters, at, stretch);

  machine::Vector6<T> tip = machine::Vector6<T>::Zero();
  ask_tip(model, parameters, at, tip);

  // T_j = lead / (2 pi) (t_nut,j + f_j)  [docs/physics.md]
  at.torque = at.drive_tension.cwiseProduct((model.machine.lead / (2 * std::numbers::pi)).template cast<T>());
  machine::PerStrut<T> torque = at.torque;
  ask_reading(model, parameters, at, torque);

  return {struts, lu, transverse, tension, at.nut_tension, at.drive_tension, stretch, tip, torque};
}

/// The same for a machine that stands where it is commanded: what the compensated pose is made from,
/// T_c = FK(IK(T) - dL(T)).
template <class T>
StrutStretch<T> strut_stretch(const ForceModel& model, const T* parameters, const Environment& environment,
                              const Motion<T>& motion) {
  const machine::StrutGeometry<T> struts = machine::strut_geometry(model.machine.geometry, motion.pose);
  const StrutRates<T> rates = strut_rates(struts, motion, environment);
  return strut_stretch_at(model, parameters, environment, motion, rates, motion.pose, struts);
}

// Instantiated once, in strut_stretch.cpp.
extern template StrutStretch<double> strut_stretch_at(const ForceModel&, const double*, const Environment&,
                                                      const Motion<double>&, const StrutRates<double>&,
                                                      const Pose<double>&, const machine::StrutGeometry<double>&);
extern template StrutStretch<double> strut_stretch(const ForceModel&, const double*, const Environment&,
                                                   const Motion<double>&);

/// The same with the model's own parameters.
inline StrutStretch<double> strut_stretch(const ForceModel& model, const Environment& environment,
                                          const Motion<double>& motion) {
  return strut_stretch(model, model.parameters.data(), environment, motion);
}

}  // namespace plumbline::physics
