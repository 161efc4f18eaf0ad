// What a model leaves of readings.
#pragma once

#include <vector>

#include "base/mean_square.hpp"
#include "identify/equations/objective.hpp"

namespace plumbline::diagnose {

/// Residuals of all runs, each run's set-up fitted; no slopes. Refuses with simulate-unreachable.
std::vector<identify::RunEquations> residuals(const machine::MachineModel& machine,
                                              const std::vector<measure::Run>& runs, const physics::ForceModel& forces,
                                              const identify::NoiseModel& noise);

/// What a model leaves of the readings of a run, or of many: of the bar, and of all motors. SI.
struct ResidualSums {
  MeanSquare radial, torque;

  ResidualSums& operator+=(const ResidualSums& other) {
    radial.add(other.radial);
    torque.add(other.torque);
    return *this;
  }
};
ResidualSums residual_sums(const identify::RunEquations& run);
/// Of the runs held out (`out`), or of the others.
ResidualSums residual_sums(const std::vector<identify::RunEquations>& runs, const std::vector<bool>& out,
                           bool held_out);

/// How far off the runs held out (`out`) are, in units of the noise, squared.
double held_out_misfit(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                       const identify::NoiseModel& noise);

}  // namespace plumbline::diagnose
