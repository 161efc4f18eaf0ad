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

ResidualSums residual_sums(const identify::RunEquations& run) {
  ResidualSums sums;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const auto first = static_cast<Eigen::Index>(c) * run.samples;
    (run.channels[c] == identify::kRadial ? sums.radial : sums.torque).add(run.residual.segment(first, run.samples));
  }
  return sums;
}

ResidualSums residual_sums(const std::vector<identify::RunEquations>& runs, const std::vector<bool>& out,
                           bool held_out) {
  ResidualSums sums;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (out[i] == held_out) sums += residual_sums(runs[i]);
  }
  return sums;
}

double held_out_misfit(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                       const identify::NoiseModel& noise) {
  const ResidualSums sums = residual_sums(residuals, out, true);
  return sums.radial.sum / std::pow(noise.channels[identify::kRadial].sigma, 2) +
         sums.torque.sum / std::pow(noise.channels[identify::kRadial + 1].sigma, 2);
}

}  // namespace plumbline::diagnose
