// The noise of each channel as its readings differ from sample to sample.
#pragma once

#include <array>
#include <vector>

#include "identify/equations/run_model.hpp"
#include "inspect/fault.hpp"

namespace plumbline::inspect {

/// Of each channel what chi-square would be if readings were off by what differs from sample to sample alone, and how
/// many readings there are.
struct FineNoise {
  static constexpr double kRemembers = 1.6;  // times as much noise as its steps show, with half of it remembered to 0.7
  std::array<double, identify::kChannels> square{};
  std::array<double, identify::kChannels> rows{};

  double with_memory() const;
  /// Chi-square with this fault mended in all runs, the assumed noise or what is there; readings of another unit have
  /// their noise scaled with them.
  double expected(const Fault& mended) const;
};

/// `remainders` in SI; `noise`: in whose units chi-square is.
FineNoise noise_from_sample_to_sample(const std::vector<identify::RunEquations>& remainders,
                                      const identify::NoiseModel& noise);

}  // namespace plumbline::inspect
