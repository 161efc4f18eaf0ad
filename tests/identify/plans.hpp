// Plans of circular tests, and machines that are not as their models say, for the tests of this module.
#pragma once

#include <random>
#include <vector>

#include "identify/unknowns/unknowns.hpp"
#include "machine/machines.hpp"
#include "measure/runs.hpp"
#include "measure/simulation.hpp"

namespace plumbline::testing {

/// Conditions A and B of the paper's Table 2.
inline std::vector<measure::Run> papers_plan(std::size_t samples = 120) {
  using measure::Direction;
  return {circle_run({0, 100, -1008}, {0, 0, 0}, Direction::ccw, samples),
          circle_run({0, 100, -1008}, {-23, 0, 0}, Direction::ccw, samples)};
}

/// Four poses at two heights, both directions.
inline std::vector<measure::Run> wider_plan(std::size_t samples = 90) {
  std::vector<measure::Run> runs;
  for (const measure::Direction direction : {measure::Direction::ccw, measure::Direction::cw}) {
    runs.push_back(circle_run({0, 100, -1008}, {-18, 0, 0}, direction, samples));
    runs.push_back(circle_run({-70, -70, -1008}, {-12, -12, 0}, direction, samples));
    runs.push_back(circle_run({80, 0, -920}, {10, 8, 0}, direction, samples));
    runs.push_back(circle_run({0, -60, -1100}, {0, 15, 0}, direction, samples));
  }
  return runs;
}

/// What a machine with these forces reads: noise of memory 0.6, the ball some 8 um off, the bar 10 um longer.
inline std::vector<measure::Run> measured(std::vector<measure::Run> runs, const physics::ForceModel& forces,
                                          double radial_sigma, double torque_sigma, Random& random) {
  std::normal_distribution<double> normal;
  const auto add_noise = [&](std::vector<double>& values, double sigma) {
    double now = sigma * normal(random);
    for (double& value : values) {
      value += now;
      now = 0.6 * now + 0.8 * sigma * normal(random);
    }
  };
  const machine::MachineModel machine = pm600_like();
  for (measure::Run& run : runs) {
    const measure::RunSimulation simulated = measure::simulate_run(machine, forces, run);
    const Vector3<double> off(8e-6 * normal(random), 8e-6 * normal(random), 8e-6 * normal(random));
    const Eigen::VectorXd radial = simulated.radial(measure::ideal_ball(run) + off, run.bar_length() + 10e-6);
    run.radial.assign(radial.begin(), radial.end());
    add_noise(run.radial, radial_sigma);
    for (int j = 0; j < machine::kStruts; ++j) {
      auto& torque = run.torque[static_cast<std::size_t>(j)];
      for (std::size_t i = 0; i < run.samples(); ++i) torque[i] = simulated.samples[i].torque[j];
      add_noise(torque, torque_sigma);
    }
  }
  return runs;
}

/// Values of the unknowns drawn from their priors.
inline Eigen::VectorXd drawn(const identify::Unknowns& unknowns, Random& random) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd values = unknowns.start();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] += unknowns[i].sigma * normal(random);
  }
  return values;
}

}  // namespace plumbline::testing
