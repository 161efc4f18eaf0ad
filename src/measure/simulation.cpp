#include "measure/simulation.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/diagnostic.hpp"

namespace plumbline::measure {

Vector3<double> ideal_ball(const Run& run) {
  const double bar = run.bar_length();
  return run.centre_W - Vector3<double>(0, 0, std::sqrt(bar * bar - run.radius * run.radius));
}

physics::Environment environment_of(const physics::ForceModel& forces, const Run& run) {
  physics::Environment environment = forces.environment();
  environment.payload_mass = run.payload_mass;
  return environment;
}

Eigen::VectorXd RunSimulation::radial(const Vector3<double>& ball_W, double bar) const {
  Eigen::VectorXd readings(static_cast<Eigen::Index>(samples.size()));
  for (Eigen::Index i = 0; i < readings.size(); ++i) {
    readings[i] = bar_reading<double>(samples[static_cast<std::size_t>(i)].tip_W, ball_W, bar);
  }
  return readings;
}

void refuse_unreachable(const Run& run, std::size_t sample, physics::ErrorStop stop) {
  refuse("simulate-unreachable",
         fmt::format("run {}: the machine cannot stand at {:.6g} deg of the circle: {}", run.id,
                     run.angle[sample] / kDeg, physics::to_text(stop)),
         "check centre_mm, radius_mm and tilt_deg of the run, and that it belongs to this machine", run.place);
}

RunSimulation simulate_run(const machine::MachineModel& machine, const physics::ForceModel& forces, const Run& run) {
  const physics::Environment environment = environment_of(forces, run);
  RunSimulation simulation;
  simulation.samples.reserve(run.samples());
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const physics::Motion<double> motion = circular_motion(machine.rotation, run, i);
    simulation.samples.push_back(simulate_sample(forces, forces.parameters.data(), environment, motion));
    const physics::ErrorStop stop = simulation.samples.back().stopped_because;
    if (stop != physics::ErrorStop::converged) refuse_unreachable(run, i, stop);
  }
  return simulation;
}

Dataset simulated(const machine::MachineModel& machine, const physics::ForceModel& forces, Dataset dataset) {
  for (Run& run : dataset.runs) {
    const RunSimulation simulation = simulate_run(machine, forces, run);
    if (run.has_radial()) {
      const Eigen::VectorXd radial = simulation.radial(ideal_ball(run), run.bar_length());
      run.radial.assign(radial.begin(), radial.end());
    }
    if (!run.has_torque()) continue;
    for (std::size_t j = 0; j < run.torque.size(); ++j) {
      for (std::size_t i = 0; i < run.samples(); ++i)
        run.torque[j][i] = simulation.samples[i].torque[static_cast<int>(j)];
    }
  }
  return dataset;
}

}  // namespace plumbline::measure
