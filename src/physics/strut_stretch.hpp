// The chain of the calculation: from where the machine stands and how it is asked to move to what each strut carries,
// how much longer it is than commanded, and what its motor pulls.
#pragma once

#include "machine/jacobian.hpp"
#include "machine/lu6.hpp"
#include "physics/hooks.hpp"

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

// The stages of the calculation. Each takes up what those before it left in the situation, so that derivatives by a sum
// in the middle begin at its stage (src/identify).

/// From gravity and masses: what pulls at the platform. `transverse` are the forces at its joints, N_j.
template <class T>
Wrench<T> wrench_from_conditions(const ForceModel& model, const Parameter<T>* parameters, const Situation<T>& at,
                                 machine::StrutVectors<T>& transverse) {
  Wrench<T> wrench;
  ask_wrench(model, parameters, at, wrench);
  ask_transverse_force(model, parameters, at, transverse);
  wrench.add_at_joints(transverse, at.struts);
  return wrench;
}

/// From the tensions of the platform joints: t_nut,j, into the situation.
template <class T>
void nut_from_joint_tension(const ForceModel& model, const Parameter<T>* parameters, Situation<T>& at,
                            const machine::PerStrut<T>& tension) {
  at.nut_tension = tension;
  ask_nut_tension(model, parameters, at, at.nut_tension);
}

/// From the tensions of the nuts: t_nut,j + f_j, into the situation.
template <class T>
void drive_from_nut_tension(const ForceModel& model, const Parameter<T>* parameters, Situation<T>& at) {
  at.drive_tension = at.nut_tension;
  ask_drive_tension(model, parameters, at, at.drive_tension);
}

/// From the tensions of the drives: dL_j, what each strut is longer than commanded, m.
template <class T>
machine::PerStrut<T> stretch_from_drive_tension(const ForceModel& model, const Parameter<T>* parameters,
                                                const Situation<T>& at) {
  machine::PerStrut<T> stretch = machine::PerStrut<T>::Zero();
  ask_length(model, parameters, at, stretch);
  return stretch;
}

/// From the tensions of the drives: displacement of the tip that no strut makes, m and rad in W.
template <class T>
machine::Vector6<T> tip_from_drive_tension(const ForceModel& model, const Parameter<T>* parameters,
                                           const Situation<T>& at) {
  machine::Vector6<T> tip = machine::Vector6<T>::Zero();
  ask_tip(model, parameters, at, tip);
  return tip;
}

/// From the tensions of the drives: the torques of the motors, into the situation, and as they are read, N m.
template <class T>
machine::PerStrut<T> reading_from_drive_tension(const ForceModel& model, const Parameter<T>* parameters,
                                                Situation<T>& at) {
  at.torque = model.machine.torque(at.drive_tension);
  machine::PerStrut<T> reading = at.torque;
  ask_reading(model, parameters, at, reading);
  return reading;
}

/// The calculation at `pose`, where the machine stands, for struts that move with `rates`, those of the commanded path.
/// `parameters` are the model's, or others in their place (parameters_as). No heap, no state: points may be computed in
/// any order.
template <class T>
StrutStretch<T> strut_stretch_at(const ForceModel& model, const Parameter<T>* parameters,
                                 const Environment& environment, const Motion<T>& motion, const StrutRates<T>& rates,
                                 const Pose<T>& pose, const machine::StrutGeometry<T>& struts) {
  Situation<T> at{model.machine, environment, motion, rates, pose, struts, {}};
  at.conditions.gravity = model.machine.gravity.template cast<T>();
  ask_conditions(model, parameters, at, at.conditions);

  machine::StrutVectors<T> transverse = machine::StrutVectors<T>::Zero();
  const Wrench<T> wrench = wrench_from_conditions(model, parameters, at, transverse);

  // J^T t = (N, M), t > 0 pulls  [Ibaraki et al., Eq. 4; docs/physics.md]
  const machine::Lu6<T> lu(machine::jacobian(struts));
  machine::Vector6<T> load;
  load << wrench.force, wrench.moment;
  const machine::PerStrut<T> tension = lu.solve_transposed(load);

  nut_from_joint_tension(model, parameters, at, tension);
  drive_from_nut_tension(model, parameters, at);
  const machine::PerStrut<T> stretch = stretch_from_drive_tension(model, parameters, at);
  const machine::Vector6<T> tip = tip_from_drive_tension(model, parameters, at);
  const machine::PerStrut<T> reading = reading_from_drive_tension(model, parameters, at);
  return {struts, lu, transverse, tension, at.nut_tension, at.drive_tension, stretch, tip, reading};
}

/// The same for a machine that stands where it is commanded: what the compensated pose is made from,
/// T_c = FK(IK(T) - dL(T)).
template <class T>
StrutStretch<T> strut_stretch(const ForceModel& model, const Parameter<T>* parameters, const Environment& environment,
                              const Motion<T>& motion) {
  const machine::StrutGeometry<T> struts = machine::strut_geometry(model.machine.geometry, motion.pose);
  const StrutRates<T> rates = strut_rates(struts, motion, environment);
  return strut_stretch_at(model, parameters, environment, motion, rates, motion.pose, struts);
}

/// How much longer a strut of that length gets for each newton that its drive pulls, m/N.
inline double drive_compliance(const ForceModel& model, int strut, double length) {
  double compliance = 0;
  for_each_instance<double>(model, model.parameters.data(), [&]<class Effect>(Values<double> p) {
    if constexpr (requires { &Effect::template compliance<double>; })
      compliance += Effect::compliance(p, strut, length);
  });
  return compliance;
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
