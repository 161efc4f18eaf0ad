// The noise of the readings: how large, and how long it remembers.
#pragma once

#include <array>
#include <vector>

#include "identify/equations/run_model.hpp"

namespace plumbline::identify {

/// Noise of one channel: an autoregressive process of the first order, a_i = memory a_(i-1) + innovation, and a part
/// that does not remember at all: e_i = a_i + b_i.
struct ChannelNoise {
  double sigma = 1;          // standard deviation of a sample, SI
  double memory = 0;         // correlation of neighbours of a, from -1 to 1
  Eigen::Index samples = 0;  // that it was estimated from
  double white = 0;          // share of b in the variance, from 0 to 1
};

struct NoiseModel {
  std::array<ChannelNoise, kAllChannels> channels;
};

/// How memory and white part of the noise are searched for.
struct ColourSearch {
  double memory_tolerance = 3e-3;  // of a memory alone: a tenth of its standard error from a thousand readings
  // a memory beside a white part: all pairs of these are tried, and from the best of them steps are made
  std::vector<double> memories{0.5, 0.75, 0.9, 0.97};
  std::vector<double> whites{0.2, 0.5, 0.8};
  /// Steps each way, halved where none is better.
  struct Steps {
    double first = 0;
    double least = 0;
  };
  Steps residuals{0.1, 0.01};        // beside the residuals alone
  Steps fitted{0.05, 0.01};          // again beside the directions of the unknowns that were fitted to them
  Steps fitted_memory{0.04, 0.003};  // likewise, of a memory alone
};

struct NoiseOptions {
  double clip = 4;  // residuals beyond that many sigma count as outliers and are cut back
  double most_memory = 0.999;
  double most_memory_beside_white = 0.98;  // more is an offset, which set-ups take
  double most_white = 0.98;                // more leaves no part that remembers
  double least_share = 0.03;  // of a direction's information that a channel gives: with less, the fit of that direction
                              // took nothing of its noise that counts
  ColourSearch search;
  double least_sigma_um = 1e-3;  // what is less is rounding
  double least_sigma_Nm = 1e-5;
  double least_sigma_rad = 1e-9;
};

/// The unknowns that were fitted to residuals, where the fit ended.
struct FittedUnknowns {
  Eigen::MatrixXd precision;  // information of all readings and of the priors, in scales
  Eigen::VectorXd scales;     // SI
  NoiseModel noise;           // that the readings were weighed with
};

/// Estimates the noise of each channel from the residuals of all runs, alike in all of them: sigma, memory and white
/// part by restricted maximum likelihood [Patterson and Thompson 1971], which allows for the set-up that each run was
/// fitted with and, with `fitted`, for the unknowns (`runs` then need their slopes): a fit takes low frequencies out of
/// the residuals, and noise would seem to remember less than it does; outliers cut back at `clip` robust standard
/// deviations (median). A white part is taken where it makes the deviance smaller by the logarithm of the number of
/// readings [Schwarz 1978]. The torques of all struts share memory and white part. Noise of a tracker does not
/// remember.
NoiseModel estimate_noise(const std::vector<RunEquations>& runs, const NoiseOptions& options = {},
                          const FittedUnknowns* fitted = nullptr);

/// Noise that does not remember, its sigma the robust standard deviation (median) of the residuals: to begin with.
NoiseModel rough_noise(const std::vector<RunEquations>& runs, const NoiseOptions& options = {});

/// The variance of noise at low frequencies, where models act, as if it were white.
double low_frequency_variance(const ChannelNoise& noise);

}  // namespace plumbline::identify
