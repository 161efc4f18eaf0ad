// A point of a path, and the motion of the machine that goes through it.
#pragma once

#include <optional>

#include "base/axes.hpp"
#include "compensate/settings.hpp"
#include "machine/orientation.hpp"
#include "physics/force_model.hpp"
#include "physics/motion.hpp"

namespace plumbline::compensate {

/// A point of a path, in W: mm and deg.
struct Target {
  AxisWords pose;
  AxisWords slope;                // derivative of the pose along the path, in any unit of the path
  AxisWords bend;                 // second derivative
  std::optional<double> seconds;  // that one such unit takes; nothing: only the direction counts
  AxisSet fixed{};                // axes that get no word: the tip alone is put right, with the orientation they leave
  /// Which way the friction of each strut acts, stated in place of the sign that its speed would give.
  std::optional<machine::PerStrut<double>> sign = std::nullopt;

  bool operator==(const Target&) const = default;
};

/// What counts on a compensated path: a delay of all drives alike does not, since the path stays the same.
physics::Environment environment_of(const physics::ForceModel& forces, const Settings& settings);

/// How the machine moves there, at a steady feed: the pose, its velocity, and, where `environment` asks for what
/// follows from accelerations, its acceleration. `radius` (m) turns a rotation into the speed of a joint. At rest where
/// the path does not move; where only the direction counts, so fast that every sign of a speed is one.
physics::Motion<double> motion_at(const machine::RotationOrder& order, double radius, const Target& target,
                                  const physics::Environment& environment);

}  // namespace plumbline::compensate
