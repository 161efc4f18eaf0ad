// What an effect sees when it is asked what it adds, and the sums that it adds to.
#pragma once

#include <numbers>

#include "physics/motion.hpp"
#include "physics/parameters.hpp"

namespace plumbline::physics {

/// What of a machine the effects need and nobody fits.
struct MachineConstants {
  machine::Geometry geometry;
  Vector3<double> gravity = Vector3<double>::Zero();                            // m/s^2 in W
  machine::PerStrut<double> lead = machine::PerStrut<double>::Zero();           // m per turn of the screw
  machine::PerStrut<double> middle_length = machine::PerStrut<double>::Zero();  // of the strut's range, m

  /// lead / (2 pi): what a strut moves while its screw turns by a radian, m; by the work done, also the torque that
  /// holds a newton, N m / N
  double lead_per_radian(int strut) const { return lead[strut] / (2 * std::numbers::pi); }
  /// 2 pi / lead: how far a screw turns for each metre of its strut, rad / m
  double radians_per_length(int strut) const { return 2 * std::numbers::pi / lead[strut]; }

  /// T_j = lead / (2 pi) (t_nut,j + f_j), of the motors, before reading effects  [docs/physics.md]
  template <class T>
  machine::PerStrut<T> torque(const machine::PerStrut<T>& drive_tension) const {
    machine::PerStrut<T> torque;
    for (int j = 0; j < machine::kStruts; ++j) torque[j] = drive_tension[j] * T(lead_per_radian(j));
    return torque;
  }
};

/// Gravity and the masses that it acts on. Starts from the machine's gravity and nothing else.
template <class T>
struct Conditions {
  Vector3<T> gravity = Vector3<T>::Zero();                         // m/s^2 in W
  T platform_mass = T(0.0);                                        // m_P, kg
  Vector3<T> centre_of_mass_P = Vector3<T>::Zero();                // c_m, m
  machine::PerStrut<T> screw_mass = machine::PerStrut<T>::Zero();  // m_B, kg
  machine::PerStrut<T> joint_mass = machine::PerStrut<T>::Zero();  // m_J
  machine::PerStrut<T> motor_mass = machine::PerStrut<T>::Zero();  // m_S
};

/// Forces on the platform, summed: N and M about the tip, in W.
template <class T>
struct Wrench {
  Vector3<T> force = Vector3<T>::Zero();   // N
  Vector3<T> moment = Vector3<T>::Zero();  // N m

  /// Adds a force that acts at `arm` from the tip (m, in W).
  void add(const Vector3<T>& force_W, const Vector3<T>& arm) {
    force += force_W;
    moment += arm.cross(force_W);
  }
  /// Adds a force at each platform joint: N += sum N_j,  M += sum b_j x N_j  [Ibaraki et al., Eq. 5]
  void add_at_joints(const machine::StrutVectors<T>& forces_W, const machine::StrutGeometry<T>& struts) {
    for (int j = 0; j < machine::kStruts; ++j) add(forces_W.col(j), struts.arm.col(j));
  }
};

/// The machine at one moment. Each step of the calculation fills in its field before the next one reads it.
template <class T>
struct Situation {
  const MachineConstants& machine;
  const Environment& environment;
  const Motion<T>& motion;           // as commanded
  const StrutRates<T>& rates;        // on the commanded path
  const Pose<T>& pose;               // where the machine stands
  machine::StrutGeometry<T> struts;  // there
  Conditions<T> conditions;
  machine::PerStrut<T> nut_tension = machine::PerStrut<T>::Zero();  // t_nut,j, N, positive pulls
  machine::PerStrut<T> drive_tension =
      machine::PerStrut<T>::Zero();                            // t_nut,j + f_j, what stretches strut and screw, N
  machine::PerStrut<T> torque = machine::PerStrut<T>::Zero();  // of the motor, before reading effects, N m

  /// From the tip to a point that is fixed in P, in W.
  Vector3<T> arm_to(const Vector3<T>& point_P) const {
    return pose.R_WP * (point_P - machine.geometry.tool_tip_P.template cast<T>());
  }
};

}  // namespace plumbline::physics
