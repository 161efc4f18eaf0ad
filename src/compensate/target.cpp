#include "compensate/target.hpp"

#include <cmath>

#include "base/units.hpp"
#include "machine/axis_words.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kSpeedOverSign = 100;  // a move without a speed counts as this many times v0
constexpr double kTurnProbe = 1e-4;     // of the path's unit, to difference the angular velocity

Vector3<double> linear(const AxisWords& words) { return {words[Axis::X], words[Axis::Y], words[Axis::Z]}; }
Vector3<double> rotary(const AxisWords& words) { return {words[Axis::A], words[Axis::B], words[Axis::C]}; }

// Per unit of the path squared.
Vector3<double> angular_acceleration(const machine::RotationOrder& order, const Vector3<double>& abc,
                                     const Vector3<double>& rate) {
  const Vector3<double> step = kTurnProbe * rate;
  return (machine::angular_velocity<double>(order, abc + step, rate) -
          machine::angular_velocity<double>(order, abc - step, rate)) /
         (2 * kTurnProbe);
}

}  // namespace

physics::Environment environment_of(const physics::ForceModel& forces, const Settings& settings) {
  physics::Environment environment = forces.environment();
  environment.friction = settings.friction;
  environment.dynamic = settings.dynamic;
  environment.late = false;
  return environment;
}

physics::Motion<double> motion_at(const machine::RotationOrder& order, double radius, const Target& target,
                                  const physics::Environment& environment) {
  physics::Motion<double> motion;
  motion.pose = machine::pose_of(order, target.pose);
  motion.twist.v_WT = linear(target.slope) * kMm;
  const Vector3<double> abc = rotary(target.pose) * kDeg;
  const Vector3<double> rate = rotary(target.slope) * kDeg;  // constant: A, B and C go linearly
  const bool turns = !rate.isZero(0);
  if (turns) motion.twist.w_WP = machine::angular_velocity<double>(order, abc, rate);
  const double size = std::hypot(motion.twist.v_WT.norm(), radius * motion.twist.w_WP.norm());
  if (size == 0) return motion;
  const double per_second = target.seconds ? 1 / *target.seconds : kSpeedOverSign * environment.sign_speed / size;
  motion.twist.v_WT *= per_second;
  motion.twist.w_WP *= per_second;
  if (!environment.dynamic || !target.seconds) return motion;
  const double per_second_2 = per_second * per_second;
  motion.acceleration.v_WT = linear(target.bend) * kMm * per_second_2;
  if (turns) motion.acceleration.w_WP = angular_acceleration(order, abc, rate) * per_second_2;
  return motion;
}

}  // namespace plumbline::compensate
