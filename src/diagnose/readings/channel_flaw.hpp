// Readings that no fault of a machine makes so: a channel in another unit, or with the other sign.
#pragma once

#include <optional>
#include <vector>

#include "identify/equations/run_model.hpp"
#include "measure/dataset.hpp"

namespace plumbline::diagnose {

struct ChannelOptions {
  double follows = 0.8;    // share of a motor's mean square that the model's torque times a factor explains
  double opposite = -0.3;  // a factor below that is another sign
  double least = 0.5;      // factors beyond these are another unit: twice what the catalogue's bounds
  double most = 1.9;       // of masses and scales allow
};

/// What is wrong with the torques of some motors, in all runs.
struct ChannelFlaw {
  enum class Kind { sign, unit };
  Kind kind = Kind::sign;
  std::vector<std::size_t> motors;  // from 0
  std::vector<double> factors;      // k of each
};

/// Each motor's torque is held against the model's: T = k T_model by least squares. Nothing: there is no flaw.
/// `residuals` are those of the base model.
std::optional<ChannelFlaw> channel_flaw(const std::vector<measure::Run>& runs,
                                        const std::vector<identify::RunEquations>& residuals,
                                        const ChannelOptions& options = {});

}  // namespace plumbline::diagnose
