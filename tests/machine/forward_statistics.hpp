// How forward kinematics fares on many poses: counted here, judged by the test and shown by the benchmark.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "machine/condition.hpp"
#include "machine/forward.hpp"
#include "machine/machines.hpp"

namespace plumbline::testing {

struct ForwardStatistics {
  int within_six = 0;
  int within_twelve = 0;
  int stated = 0;      // not converged, and said so
  int wrong_side = 0;  // converged on another side of a singularity than the home pose's
  int elsewhere = 0;   // converged on the right side, but not to the pose that the lengths came from
  double steps = 0;    // of all that converged
  double worst_residual_m = 0;
};

inline std::string to_text(const ForwardStatistics& s) {
  return fmt::format(
      "{} within 6 steps, {} within 12, {} stated failures, {} on the wrong side, {} elsewhere, {} steps", s.within_six,
      s.within_twelve, s.stated, s.wrong_side, s.elsewhere, s.steps);
}

inline double condition_of(const machine::MachineModel& model, const machine::StrutGeometry<double>& struts) {
  return machine::condition_number(struts, machine::platform_radius(model.geometry));
}

/// Draws poses within the limits on the home pose's side of every singularity, and starts up to 50 mm and 10 deg away.
inline ForwardStatistics forward_statistics(const machine::MachineModel& model, int poses, std::uint64_t seed) {
  Random random(seed);
  const Pose<double> home = machine::home_pose(model);
  const int side = machine::side_of(model.geometry, home);
  ForwardStatistics found;
  for (int n = 0; n < poses; ++n) {
    Pose<double> pose = pose_within(model.limits, random);
    while (machine::side_of(model.geometry, pose) != side) pose = pose_within(model.limits, random);
    const Pose<double> start = pose_beside(pose, 50 * kMm, 10 * kDeg, random);
    const auto lengths = machine::strut_lengths(model.geometry, pose);
    const machine::ForwardResult result =
        machine::forward(model.geometry, lengths, start, {.side = side, .second_start = home});
    if (!result.converged()) {
      ++found.stated;
      continue;
    }
    found.steps += result.iterations;
    if (result.iterations <= 6) ++found.within_six;
    if (result.iterations <= 12) ++found.within_twelve;
    if (machine::side_of(model.geometry, result.pose) != side) ++found.wrong_side;
    if (machine::displacement_between(pose, result.pose).norm() > 1e-6) ++found.elsewhere;
    const double residual = (machine::strut_lengths(model.geometry, result.pose) - lengths).cwiseAbs().maxCoeff();
    found.worst_residual_m = std::max(found.worst_residual_m, residual);
  }
  return found;
}

}  // namespace plumbline::testing
