// The machines that the tests run on, and poses drawn inside their limits.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "machine/displacement.hpp"
#include "machine/model_file.hpp"

namespace plumbline::testing {

inline std::string source_path(const std::string& file) { return std::string(PLUMBLINE_SOURCE_DIR) + "/" + file; }

inline machine::MachineModel pm600_like() { return machine::read_model(source_path("models/pm600-like.toml")); }

/// Three geometries that differ: short wide struts, a small platform, a wide one.
inline std::vector<machine::MachineModel> three_machines() {
  return {pm600_like(), machine::read_model(source_path("tests/machine/data/delta-like.toml")),
          machine::read_model(source_path("tests/machine/data/wide-like.toml"))};
}

using Random = std::mt19937_64;

inline double uniform(Random& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

/// A unit vector, evenly distributed.
inline Vector3<double> direction(Random& random) {
  std::normal_distribution<double> normal;
  return Vector3<double>(normal(random), normal(random), normal(random)).normalized();
}

/// A pose inside the travel, tilted within the limit about any horizontal axis and turned up to 10 deg about Z of P.
inline Pose<double> pose_within(const machine::Limits& limits, Random& random) {
  Pose<double> pose;
  for (int a = 0; a < 3; ++a) {
    const machine::Range& range = limits.travel[static_cast<std::size_t>(a)];
    pose.p_WT[a] = uniform(random, range.lower, range.upper);
  }
  const double about = uniform(random, 0, 2 * std::numbers::pi);
  const Vector3<double> axis(std::cos(about), std::sin(about), 0);
  const Vector3<double> tilt = uniform(random, 0, limits.tilt) * axis;
  pose.R_WP = machine::exponential(tilt) * machine::axis_rotation(2, uniform(random, -10 * kDeg, 10 * kDeg));
  return pose;
}

/// A pose up to that far (m, rad) from another one.
inline Pose<double> pose_beside(const Pose<double>& pose, double distance, double turn, Random& random) {
  machine::Vector6<double> displacement;
  displacement.head<3>() = uniform(random, 0, distance) * direction(random);
  displacement.tail<3>() = uniform(random, 0, turn) * direction(random);
  return machine::displaced(pose, displacement);
}

}  // namespace plumbline::testing
