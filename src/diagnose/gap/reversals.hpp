// Steps of the readings where a strut turns around.
#pragma once

#include "diagnose/gap/channels.hpp"
#include "diagnose/readings/sample_states.hpp"

namespace plumbline::diagnose {

/// What readings do where a strut turns around, in the direction of its growing speed: as a change of the strut's
/// length (from the bar), and of its motor's torque. SI.
struct Reversal {
  int strut = 0;
  int count = 0;
  double length = 0;
  double length_error = 0;  // standard error, from the scatter of the steps; 0: not measured
  double torque = 0;
  double torque_error = 0;
};

struct ReversalOptions {
  double window = 0.21;  // rad, half of it before a reversal, half after
};

/// One for each strut. `states` are those of the runs' samples.
std::vector<Reversal> reversals_of(const std::vector<measure::Run>& runs,
                                   const std::vector<std::vector<SampleState>>& states,
                                   const std::vector<identify::RunEquations>& residuals,
                                   const ReversalOptions& options = {});

}  // namespace plumbline::diagnose
