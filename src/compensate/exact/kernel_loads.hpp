// What both kernels begin with: where the machine is sent to, how it moves there, and what its struts carry.
#pragma once

#include "base/units.hpp"
#include "compensate/exact/pose_block.hpp"
#include "compensate/exact/setup.hpp"
#include "machine/axis_turns.hpp"
#include "machine/displacement.hpp"
#include "machine/ordered_lu6.hpp"
#include "physics/strut_stretch.hpp"

namespace plumbline::compensate::exact {

constexpr double kSpeedOverSign = 100;  // as in compensate/target.cpp

template <class T>
struct Asked {
  Vector3<T> linear, rotary;  // mm, deg
  Vector3<T> linear_slope, rotary_slope;
  Vector3<T> linear_bend;
  T seconds;
};

template <class T>
PLUMBLINE_INLINE T squared(const Vector3<T>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

template <class T>
PLUMBLINE_INLINE Asked<T> read(const AskedBlock& block, std::size_t lane) {
  Asked<T> asked;
  for (int a = 0; a < 3; ++a) {
    const auto x = static_cast<std::size_t>(a);
    asked.linear[a] = T::load(&block.pose[x][lane]);
    asked.rotary[a] = T::load(&block.pose[x + 3][lane]);
    asked.linear_slope[a] = T::load(&block.slope[x][lane]);
    asked.rotary_slope[a] = T::load(&block.slope[x + 3][lane]);
    asked.linear_bend[a] = T::load(&block.bend[x][lane]);
  }
  asked.seconds = T::load(&block.seconds[lane]);
  return asked;
}

/// The commanded motion, and in `per_sign_speed` 1 / v0 as `friction` has it.
template <class T>
PLUMBLINE_INLINE physics::Motion<T> motion_of(const Setup& setup, Friction friction, const Asked<T>& asked,
                                              const machine::AxisTurns<T>& turns, T& per_sign_speed) {
  physics::Motion<T> motion;
  motion.time = T(setup.time);
  motion.pose.p_WT = asked.linear * T(kMm);
  motion.pose.R_WP = machine::rotation(setup.rotation, turns);
  const T model_speed(setup.environment.sign_speed);
  per_sign_speed = T(1.0) / model_speed;
  if (!setup.environment.friction) return motion;
  const Vector3<T> rate = asked.rotary_slope * T(kDeg);
  const machine::Turning<T> turning = machine::turning(setup.rotation, turns, rate);
  const Vector3<T> along = asked.linear_slope * T(kMm);
  const T size = sqrt(squared(along) + T(setup.radius * setup.radius) * squared(turning.velocity));
  const auto timed = asked.seconds >= T(0.0);
  const T direction_alone = T(kSpeedOverSign) * model_speed / select<T>(size > T(0.0), size, T(__builtin_inf()));
  const T per_second = select<T>(timed, T(1.0) / select<T>(timed, asked.seconds, T(1.0)), direction_alone);
  motion.twist.v_WT = along * per_second;
  motion.twist.w_WP = turning.velocity * per_second;
  if (friction == Friction::smoothed) {
    const T feed_share = T(setup.sign_width_of_feed) * (size * per_second);
    per_sign_speed = T(1.0) / select<T>(feed_share > model_speed, feed_share, model_speed);
  }
  if (setup.environment.dynamic) {
    const T twice = select<T>(timed, per_second * per_second, T(0.0));
    motion.acceleration.v_WT = asked.linear_bend * (T(kMm) * twice);
    motion.acceleration.w_WP = turning.acceleration * twice;
  }
  return motion;
}

/// R <- exp(w) R to the sixth order of w, as machine::small_rotation has it.
template <class T>
PLUMBLINE_INLINE Matrix3<T> turned(const Vector3<T>& w, const Matrix3<T>& R) {
  const T t2 = squared(w);
  const T a = T(1.0) - t2 * (T(1.0 / 6.0) - t2 * T(1.0 / 120.0));
  const T b = T(0.5) - t2 * (T(1.0 / 24.0) - t2 * T(1.0 / 720.0));
  Matrix3<T> result;
#pragma GCC unroll 3
  for (int q = 0; q < 3; ++q) {
    const Vector3<T> r(R(0, q), R(1, q), R(2, q));
    const Vector3<T> once(w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2], w[0] * r[1] - w[1] * r[0]);
    result(0, q) = r[0] + a * once[0] + b * (w[1] * once[2] - w[2] * once[1]);
    result(1, q) = r[1] + a * once[1] + b * (w[2] * once[0] - w[0] * once[2]);
    result(2, q) = r[2] + a * once[2] + b * (w[0] * once[1] - w[1] * once[0]);
  }
  return result;
}

/// What the struts carry at a pose, and what it does to them.
template <class T>
struct Loads {
  machine::OrderedLu6<T> lu;  // of the Jacobian
  machine::PerStrut<T> nut_tension;
  machine::PerStrut<T> stretch;
  machine::Vector6<T> tip;  // zero unless setup.has_tip
};

template <class T>
PLUMBLINE_INLINE Loads<T> loads_at(const Setup& setup, const physics::Motion<T>& motion,
                                   const physics::StrutRates<T>& rates, const Pose<T>& pose,
                                   const machine::StrutGeometry<T>& struts) {
  const physics::ForceModel& forces = *setup.forces;
  const double* const parameters = forces.parameters.data();
  physics::Situation<T> at{forces.machine, setup.environment, motion, rates, pose, struts, {}};
  at.conditions.gravity = forces.machine.gravity.template cast<T>();
  physics::ask_conditions(forces, parameters, at, at.conditions);
  machine::StrutVectors<T> transverse = machine::StrutVectors<T>::Zero();
  const physics::Wrench<T> wrench = physics::wrench_from_conditions(forces, parameters, at, transverse);
  machine::Vector6<T> load;
  load << wrench.force, wrench.moment;
  Loads<T> loads{{machine::jacobian(struts), setup.rows}, {}, {}, machine::Vector6<T>::Zero()};
  physics::nut_from_joint_tension<T>(forces, parameters, at, loads.lu.solve_transposed(load));
  loads.nut_tension = at.nut_tension;
  physics::drive_from_nut_tension(forces, parameters, at);
  loads.stretch = physics::stretch_from_drive_tension(forces, parameters, at);
  if (setup.has_tip) loads.tip = physics::tip_from_drive_tension(forces, parameters, at);
  return loads;
}

}  // namespace plumbline::compensate::exact
