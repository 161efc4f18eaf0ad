#include "diagnose/next_test.hpp"

#include <algorithm>
#include <cmath>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "diagnose/evidence/linear_problem.hpp"
#include "measure/planned_run.hpp"

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
  measure::lay_samples(run, static_cast<std::size_t>(samples), like.has_radial(), like.has_torque());
  return run;
}

double separation(const machine::MachineModel& machine, const physics::ForceModel& one,
                  const physics::ForceModel& other, const Run& run, const identify::NoiseModel& noise,
                  double most_off) {
  try {
    const identify::SimulatedRun by_one = identify::simulate_run(machine.rotation, one, run);
    const identify::SimulatedRun by_other = identify::simulate_run(machine.rotation, other, run);
    if (std::max(by_one.furthest_off, by_other.furthest_off) > most_off) return 0;
    const measure::Setup setup = identify::ideal_setup(run);
    const identify::RunEquations a = identify::run_equations(run, by_one, setup);
    const identify::RunEquations b = identify::run_equations(run, by_other, setup);
    return without_setup(a, a.residual - b.residual, noise).norm();
  } catch (const Refusal&) {
    return 0;  // a machine that cannot stand there cannot be tested there
  }
}

std::vector<Run> designs(const machine::MachineModel& machine, const Run& like, const NextTestOptions& options) {
  const Vector3<double> middle = machine::home_pose(machine).p_WT;
  const double tilt = options.tilt_share * machine.limits.tilt;
  const double both = options.both_axes * tilt;
  const std::vector<std::pair<double, double>> tilts{{0, 0},     {tilt, 0},    {-tilt, 0},    {0, tilt},
                                                     {0, -tilt}, {both, both}, {-both, -both}};
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
    if (measure::within_limits(machine, all[i]))
      separations[i] = separation(machine, one, other, all[i], noise, options.most_off);
  });
  std::size_t best = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    // a simpler test (earlier: ccw, no payload, slow) is preferred unless another is clearly better
    if (separations[i] > options.clearly_better * separations[best]) best = i;
  }
  // as many more samples as a run has tell so much more
  const double more = std::sqrt(static_cast<double>(like.samples()) / options.samples);
  if (separations.empty() || separations[best] * more < options.least_separation) return std::nullopt;
  return NextTest{all[best], separations[best] * more};
}

}  // namespace plumbline::diagnose
