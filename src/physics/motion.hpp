// How the machine is asked to move, and what follows for each strut.
#pragma once

#include <array>

#include <Eigen/Geometry>

#include "base/pose.hpp"
#include "base/units.hpp"
#include "machine/inverse.hpp"

namespace plumbline::physics {

/// The smoothed sign s_j of each strut's speed.
using StrutSigns = std::array<double, machine::kStruts>;

/// The commanded motion at one moment.
template <class T>
struct Motion {
  Pose<T> pose;
  Twist<T> twist;         // zero: at rest, and friction is silent
  Twist<T> acceleration;  // of the tip, m/s^2, and of the turning, rad/s^2
  T time = T(0.0);        // s, on the clock of the dataset
  // In place of tanh(Ldot_j / v0), of a moment that stands for many: what their low-pass makes of it. Not kept.
  const StrutSigns* signs = nullptr;
};

/// What is known of the moment besides the motion.
struct Environment {
  bool friction = true;  // false: as if at rest, whatever the motion; what depends on direction and speed is silent
  bool dynamic = true;   // false: inertia and the control's following error are silent; a control may shape its speed
  bool late = true;      // false: where a path counts, not the moment: what delays all struts alike is no error of it
  double sign_speed = 0.02 * kMm;                           // v0 in s = tanh(Ldot / v0), m/s
  double tool_mass = 0;                                     // kg more (or less) than the platform's mass contains
  Vector3<double> tool_centre_P = Vector3<double>::Zero();  // its centre of mass in P, m
  double payload_mass = 0;                                  // kg, known, hung at the tool tip
};

/// Motion of the struts on the commanded path.
template <class T>
struct StrutRates {
  machine::PerStrut<T> speed;           // Ldot_j, m/s
  machine::PerStrut<T> acceleration;    // Lddot_j, m/s^2
  machine::PerStrut<T> sign;            // s_j, the smoothed sign of Ldot_j
  machine::StrutVectors<T> transverse;  // v_perp,j of the platform joint, across the strut, m/s in W
};

/// Ldot_j = u_j . v_j, v_j = v + w x b_j the velocity of the platform joint; v_perp,j = v_j - (u_j . v_j) u_j;
/// Lddot_j = u_j . a_j + |v_perp,j|^2 / L_j, a_j = a + alpha x b_j + w x (w x b_j); s_j = tanh(Ldot_j / v0)
/// unless the motion says otherwise [docs/physics.md]
/// `per_sign_speed` is 1 / v0. Accelerations are zero where the environment has no use for them.
template <class T>
StrutRates<T> strut_rates(const machine::StrutGeometry<T>& struts, const Motion<T>& motion,
                          const Environment& environment, const T& per_sign_speed) {
  using std::tanh;
  StrutRates<T> rates;
  if (!environment.friction) {
    rates.speed.setZero();
    rates.acceleration.setZero();
    rates.sign.setZero();
    rates.transverse.setZero();
    return rates;
  }
  const Vector3<T>& w = motion.twist.w_WP;
  for (int j = 0; j < machine::kStruts; ++j) {
    const Vector3<T> b = struts.arm.col(j);
    const Vector3<T> u = struts.direction.col(j);
    const Vector3<T> turning = w.cross(b);
    const Vector3<T> v = motion.twist.v_WT + turning;
    const T speed = u.dot(v);
    const Vector3<T> across = v - speed * u;
    rates.speed[j] = speed;
    rates.acceleration[j] = T(0.0);
    if (environment.dynamic) {
      const Vector3<T> a = motion.acceleration.v_WT + motion.acceleration.w_WP.cross(b) + w.cross(turning);
      rates.acceleration[j] = u.dot(a) + across.squaredNorm() / struts.length[j];
    }
    rates.sign[j] =
        motion.signs != nullptr ? T((*motion.signs)[static_cast<std::size_t>(j)]) : T(tanh(speed * per_sign_speed));
    rates.transverse.col(j) = across;
  }
  return rates;
}
template <class T>
StrutRates<T> strut_rates(const machine::StrutGeometry<T>& struts, const Motion<T>& motion,
                          const Environment& environment) {
  return strut_rates(struts, motion, environment, T(1.0 / environment.sign_speed));
}

}  // namespace plumbline::physics
