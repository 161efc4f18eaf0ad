#include "diagnose/readings/residuals.hpp"

#include <cmath>

namespace plumbline::diagnose {

std::vector<identify::RunEquations> residuals(const machine::MachineModel& machine,
                                              const std::vector<measure::Run>& runs, const physics::ForceModel& forces,
                                              const identify::NoiseModel& noise) {
  identify::Objective objective(machine.rotation, runs, identify::Unknowns(forces), {.huber = 0});
  objective.set_noise(noise);
  return objective.equations(Eigen::VectorXd(0));
}

ResidualSums left_of(const identify::RunEquations& run) {
  ResidualSums left;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const auto first = static_cast<Eigen::Index>(c) * run.samples;
    (run.channels[c] == identify::kRadial ? left.radial : left.torque).add(run.residual.segment(first, run.samples));
  }
  return left;
}

ResidualSums left_of(const std::vector<identify::RunEquations>& runs, const std::vector<bool>& out, bool held_out) {
  ResidualSums left;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (out[i] == held_out) left += left_of(runs[i]);
  }
  return left;
}

double held_out_misfit(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                       const identify::NoiseModel& noise) {
  const ResidualSums left = left_of(residuals, out, true);
  return left.radial.sum / std::pow(noise.channels[identify::kRadial].sigma, 2) +
         left.torque.sum / std::pow(noise.channels[identify::kRadial + 1].sigma, 2);
}

}  // namespace plumbline::diagnose
