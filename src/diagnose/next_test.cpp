#include "diagnose/next_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "diagnose/linear_problem.hpp"
#include "machine/inverse.hpp"
#include "machine/orientation.hpp"

namespace plumbline::diagnose {
namespace {

using measure::Run;

Run designed(const Run& like, const Vector3<double>& centre, const Vector3<double>& tilt, measure::Direction direction,
             double feed, double payload, int samples) {
  Run run;
  run.centre_W = centre;
  run.radius = like.radius;
  run.bar = like.bar;
  run.tilt = tilt;
  run.direction = direction;
  run.feed = feed;
  run.payload_mass = payload;
  for (int i = 0; i < samples; ++i) {
    const double turn = 2 * std::numbers::pi * i / samples;
    run.time.push_back(turn * run.radius / feed);
    run.angle.push_back(run.turn() * turn);
  }
  const std::vector<double> nothing(static_cast<std::size_t>(samples), 0);
  if (like.has_radial()) run.radial = nothing;
  if (like.has_torque()) run.torque.fill(nothing);
  return run;
}

bool within(const machine::MachineModel& machine, const Run& run) {
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const Pose<double> pose = measure::circular_motion(machine.rotation, run, i).pose;
    for (int a = 0; a < 3; ++a) {
      const machine::Range& range = machine.limits.travel[static_cast<std::size_t>(a)];
      if (pose.p_WT[a] < range.lower || pose.p_WT[a] > range.upper) return false;
    }
    const machine::PerStrut<double> L = machine::strut_lengths(machine.geometry, pose);
    if ((L.array() < machine.limits.length_min.array()).any() ||
        (L.array() > machine.limits.length_max.array()).any()) {
      return false;
    }
    if (std::acos(std::clamp(pose.R_WP(2, 2), -1.0, 1.0)) > machine.limits.tilt) return false;
  }
  return true;
}

double separation(const machine::MachineModel& machine, const physics::ForceModel& one,
                  const physics::ForceModel& other, const Run& run, const identify::NoiseModel& noise) {
  try {
    const measure::Setup setup = identify::ideal_setup(run);
    const identify::RunEquations a =
        identify::run_equations(run, identify::simulate_run(machine.rotation, one, run), setup);
    const identify::RunEquations b =
        identify::run_equations(run, identify::simulate_run(machine.rotation, other, run), setup);
    return without_setup(a, a.residual - b.residual, noise).norm();
  } catch (const Refusal&) {
    return 0;  // a machine that cannot stand there cannot be tested there
  }
}

std::vector<Run> designs(const machine::MachineModel& machine, const Run& like, const NextTestOptions& options) {
  const Vector3<double> middle = machine::home_pose(machine).p_WT;
  const double tilt = options.tilt_share * machine.limits.tilt;
  const std::vector<std::pair<double, double>> tilts{
      {0, 0}, {tilt, 0}, {-tilt, 0}, {0, tilt}, {0, -tilt}, {0.7 * tilt, 0.7 * tilt}, {-0.7 * tilt, -0.7 * tilt}};
  std::vector<Run> all;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        const Vector3<double> centre = middle + options.off_centre * Vector3<double>(x, y, z);
        for (const auto& [a, b] : tilts) {
          for (const double feed : options.feeds_mm_min) {
            for (const double payload : options.payloads_kg) {
              for (const measure::Direction direction : {measure::Direction::ccw, measure::Direction::cw}) {
                all.push_back(designed(like, centre, {a, b, 0}, direction, feed * kMmPerMin, payload, options.samples));
              }
            }
          }
        }
      }
    }
  }
  return all;
}

}  // namespace

std::optional<NextTest> next_test(const machine::MachineModel& machine, const physics::ForceModel& one,
                                  const physics::ForceModel& other, const Run& like, const identify::NoiseModel& noise,
                                  const NextTestOptions& options) {
  const std::vector<Run> all = designs(machine, like, options);
  std::vector<double> separations(all.size(), 0);
  for_each_index(all.size(), [&](std::size_t i) {
    if (within(machine, all[i])) separations[i] = separation(machine, one, other, all[i], noise);
  });
  std::size_t best = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    // a simpler test (earlier: ccw, no payload, slow) is preferred unless another is clearly better
    if (separations[i] > 1.02 * separations[best]) best = i;
  }
  // as many more samples as a run has tell so much more
  const double more = std::sqrt(static_cast<double>(like.samples()) / options.samples);
  if (separations.empty() || separations[best] * more < 1) return std::nullopt;
  return NextTest{all[best], separations[best] * more};
}

}  // namespace plumbline::diagnose
