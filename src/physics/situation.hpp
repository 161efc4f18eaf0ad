// What an effect sees when it is asked what it adds, and the sums that it adds to.
#pragma once

#include "physics/motion.hpp"
#include "physics/parameters.hpp"

namespace plumbline::physics {

/// What of a machine the effects need and nobody fits.
struct MachineConstants {
  machine::Geometry geometry;
  Vector3<double> gravity = Vector3<double>::Zero();                            // m/s^2 in W
  machine::PerStrut<double> lead = machine::PerStrut<double>::Zero();           // m per turn of the screw
  machine::PerStrut<double> middle_length = machine::PerStrut<double>::Zero();  // of the strut's range, m
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
