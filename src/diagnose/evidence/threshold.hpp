// The threshold above which an effect counts as found: what the best of the whole catalogue reaches by chance.
#pragma once

#include <cstdint>

#include "diagnose/evidence/score.hpp"

namespace plumbline::diagnose {

struct ThresholdOptions {
  double false_alarms = 0.003;
  int draws = 20000;
  double noise_uncertainty = 0.1;  // relative, of the noise's size: one sigma
  std::uint64_t seed = 1;
  // spreads of sizes that are tried, tau^2 in units of what the data tell: coarser than for one effect, since there are
  // thousands of draws
  double widest = 1e6;
  double wider_times = 4;
};

struct Threshold {
  double log_odds = 0;  // that an effect must reach
  int draws = 0;
};

/// Parametric bootstrap of the maximum over the whole catalogue with nothing missing. What noise makes of the slopes of
/// all columns is normal with covariance `left` (Gram matrix, what has been taken out, residual last): drawn directly,
/// without readings. Struts one by one and all together are tried, bounds left out, which errs on the safe side.
Threshold threshold(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const ScoreOptions& scoring = {},
                    const ThresholdOptions& options = {});

}  // namespace plumbline::diagnose
