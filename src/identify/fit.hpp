// The fit of a model's unknowns to the runs of a dataset.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/equations/objective.hpp"

namespace plumbline::identify {

struct FitOptions {
  ObjectiveOptions objective;
  NoiseOptions noise;
  std::optional<NoiseModel> known_noise;  // if given, the noise is not estimated
  int most_noise_rounds = 5;
  double noise_tolerance = 0.03;     // relative change of the noise's weight at which rounds end
  int most_iterations = 40;          // of each round
  double misfit_tolerance = 1e-8;    // relative change of the misfit at which iterations end
  std::size_t coarse_samples = 180;  // of each run, in a first fit that only tells the last one where to start; runs
                                     // that have hardly more are fitted at once
};

/// The values with the greatest posterior density, and how sure they are. Vectors and matrices in the order of the
/// unknowns, SI.
struct Fit {
  explicit Fit(Unknowns of) : unknowns(std::move(of)) {}

  Unknowns unknowns;
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;   // linearised; infinite variance where neither data nor prior tell
  Eigen::MatrixXd information;  // of the data alone, in scales of the unknowns
  NoiseModel noise;
  std::vector<measure::Setup> setups;  // of each run
  TrackerFrame frame;
  double misfit = 0;  // of the data, in units of the noise
  Eigen::Index readings = 0;
  double fitted_degrees = 0;  // how many unknowns the data determine, as a sum of shares
  int iterations = 0;
  bool converged = false;
  std::string stopped_because;  // in words

  double standard_error(std::size_t i) const;
  double correlation(std::size_t i, std::size_t k) const;
  /// The standard error of each parameter of forces(), SI; zero for what was not fitted.
  std::vector<double> parameter_errors() const;
  /// The force model with the values found.
  physics::ForceModel forces() const { return unknowns.at(values); }
};

/// Fits by Levenberg-Marquardt within the bounds, derivatives exact, the noise estimated between rounds, from
/// the unknowns' start. `tracked`: poses that a tracker measured, beside the runs or alone. Refuses with
/// simulate-unreachable and tracker-far.
Fit fit(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Unknowns& unknowns,
        const FitOptions& options = {}, const Tracked* tracked = nullptr);

/// A square root of a covariance, R R^T; what rounding makes negative is nil.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& covariance);

/// 1 / sigma^2 of each prior, in scales; zero for what is free.
Eigen::VectorXd prior_weights(const Unknowns& unknowns);

/// The covariance (SI) of unknowns of which data tell `information` (in scales), with their priors; infinite variances
/// for what neither tells.
Eigen::MatrixXd posterior_covariance(const Unknowns& unknowns, const Eigen::MatrixXd& information);

}  // namespace plumbline::identify
