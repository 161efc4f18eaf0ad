#include "identify/fit.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "base/diagnostic.hpp"
#include "identify/levenberg_marquardt.hpp"

namespace plumbline::identify {
namespace {

// Eigenvalues of an information matrix below this share of the largest count as none.
constexpr double kLeastInformation = 1e-14;

// A direction that nothing tells leaves an unknown open whose part in it is more than rounding.
constexpr double kPartOfDirection = 1e-6;

struct Round {
  Eigen::VectorXd values;
  int iterations = 0;
  bool converged = false;
  std::string message;
};

// In scales from the unknowns' start: the misfit of the data and of the priors.
Round minimise(Objective& objective, const Eigen::VectorXd& from, const FitOptions& options) {
  const Unknowns& unknowns = objective.unknowns();
  const Eigen::VectorXd start = unknowns.start();
  const Eigen::VectorXd scales = unknowns.scales();
  const Eigen::VectorXd prior = prior_weights(unknowns);
  const auto sum_at = [&](const Eigen::VectorXd& z, bool derivatives) -> std::optional<SumOfSquares> {
    NormalEquations normal;
    try {
      normal = objective.evaluate(start + scales.cwiseProduct(z), derivatives);
    } catch (const Refusal&) {
      return std::nullopt;  // out of reach there
    }
    const double misfit = normal.misfit + z.cwiseAbs2().dot(prior);
    if (!derivatives) return SumOfSquares{misfit, {}, {}};
    normal.information.diagonal() += prior;
    normal.gradient += prior.cwiseProduct(z);
    return SumOfSquares{misfit, std::move(normal.gradient), std::move(normal.information)};
  };
  Bounds bounds{start, start};
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    bounds.lower[k] = (unknowns[i].lower - unknowns[i].start) / unknowns[i].scale;
    bounds.upper[k] = (unknowns[i].upper - unknowns[i].start) / unknowns[i].scale;
  }
  LeastOptions least;
  least.most_iterations = options.most_iterations;
  least.misfit_tolerance = options.misfit_tolerance;
  least.least_information = kLeastInformation;
  const Least found = least_squares(sum_at, (from - start).cwiseQuotient(scales), bounds, least);
  return {start + scales.cwiseProduct(found.z), found.iterations, found.converged, found.stopped_because};
}

// How much heavier or lighter readings become between two estimates of the noise, at low frequencies, where the model
// acts: relative.
double change_of(const NoiseModel& from, const NoiseModel& to) {
  double most = 0;
  for (std::size_t c = 0; c < from.channels.size(); ++c) {
    if (to.channels[c].samples == 0) continue;
    const double ratio = low_frequency_variance(to.channels[c]) / low_frequency_variance(from.channels[c]);
    most = std::max(most, std::abs(std::sqrt(ratio) - 1));
  }
  return most;
}

// How many unknowns the data determine: each counts as far as its prior no longer matters.
double degrees_of(const Unknowns& unknowns, const Eigen::MatrixXd& covariance) {
  double degrees = 0;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    degrees += unknowns[i].free() ? 1 : 1 - covariance(k, k) / (unknowns[i].sigma * unknowns[i].sigma);
  }
  return degrees;
}

}  // namespace

Eigen::VectorXd prior_weights(const Unknowns& unknowns) {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(unknowns.size()));
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const double ratio = unknowns[i].free() ? 0 : unknowns[i].scale / unknowns[i].sigma;
    weights[static_cast<Eigen::Index>(i)] = ratio * ratio;
  }
  return weights;
}

Eigen::MatrixXd root_of(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(covariance);
  return parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

double Fit::standard_error(std::size_t i) const {
  const auto k = static_cast<Eigen::Index>(i);
  return std::sqrt(covariance(k, k));
}

double Fit::correlation(std::size_t i, std::size_t k) const {
  const double both = standard_error(i) * standard_error(k);
  return std::isfinite(both) ? covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) / both : 0;
}

std::vector<double> Fit::parameter_errors() const {
  std::vector<double> errors(unknowns.forces().parameters.size(), 0);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    for (const Unknown::Term& term : unknowns[i].terms) {
      double& error = errors[static_cast<std::size_t>(term.parameter)];
      error = std::hypot(error, term.weight * standard_error(i));
    }
  }
  return errors;
}

Eigen::MatrixXd posterior_covariance(const Unknowns& unknowns, const Eigen::MatrixXd& information) {
  const Eigen::VectorXd scales = unknowns.scales();
  Eigen::MatrixXd precision = information;
  precision.diagonal() += prior_weights(unknowns);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(precision);
  const double least = kLeastInformation * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  const Eigen::VectorXd inverse =
      eigen.eigenvalues().unaryExpr([least](double value) { return value > least ? 1 / value : 0; });
  const Eigen::MatrixXd& V = eigen.eigenvectors();
  Eigen::MatrixXd covariance = scales.asDiagonal() * (V * inverse.asDiagonal() * V.transpose()) * scales.asDiagonal();
  for (Eigen::Index k = 0; k < inverse.size(); ++k) {
    if (inverse[k] > 0) continue;
    for (Eigen::Index i = 0; i < V.rows(); ++i) {
      if (std::abs(V(i, k)) > kPartOfDirection) covariance(i, i) = std::numeric_limits<double>::infinity();
    }
  }
  return covariance;
}

namespace {

// Every `stride`-th sample of each run.
std::vector<measure::Run> thinned(const std::vector<measure::Run>& runs, std::size_t stride) {
  std::vector<measure::Run> thin = runs;
  for (measure::Run& run : thin) {
    const auto keep = [stride](auto& column) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < column.size(); i += stride) column[kept++] = column[i];
      column.resize(kept);
    };
    for (auto* column : {&run.time, &run.angle, &run.radial}) keep(*column);
    for (auto& column : run.torque) keep(column);
    keep(run.signs);
  }
  return thin;
}

// Rounds of a fit with the noise held, and of the noise with the fit held, until the noise settles.
Round rounds(Objective& objective, Eigen::VectorXd values, const FitOptions& options) {
  Round last;
  for (int round = 1;; ++round) {
    const int before = last.iterations;
    last = minimise(objective, values, options);
    last.iterations += before;
    values = last.values;
    if (options.known_noise || round >= options.most_noise_rounds) return last;
    FittedUnknowns fitted{objective.evaluate(values, true).information, objective.unknowns().scales(),
                          objective.noise()};
    fitted.precision.diagonal() += prior_weights(objective.unknowns());
    const NoiseModel noise = estimate_noise(objective.equations(values, true), options.noise, &fitted);
    if (change_of(objective.noise(), noise) <= options.noise_tolerance) return last;
    objective.set_noise(noise);
  }
}

}  // namespace

Fit fit(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Unknowns& unknowns,
        const FitOptions& options, const Tracked* tracked) {
  Objective objective(order, runs, unknowns, options.objective, tracked);
  Eigen::VectorXd start = unknowns.start();
  std::size_t shortest = std::numeric_limits<std::size_t>::max();
  for (const measure::Run& run : runs) shortest = std::min(shortest, run.samples());
  const std::size_t stride = runs.empty() ? 0 : shortest / std::max<std::size_t>(options.coarse_samples, 1);
  if (options.known_noise) {
    objective.set_noise(*options.known_noise);
  } else if (stride < 3) {
    objective.set_noise(rough_noise(objective.equations(start), options.noise));
  } else {
    const std::vector<measure::Run> few = thinned(runs, stride);
    Objective coarse(order, few, unknowns, options.objective, tracked);
    coarse.set_noise(rough_noise(coarse.equations(start), options.noise));
    start = rounds(coarse, start, options).values;
    objective.set_setups(coarse.setups());
    objective.set_noise(coarse.noise());
    objective.simulate(start, true);
    objective.set_noise(estimate_noise(objective.equations(start), options.noise));
  }
  const Round found = rounds(objective, start, options);
  const NormalEquations normal = objective.evaluate(found.values, true);

  Fit result(unknowns);
  result.values = found.values;
  result.iterations = found.iterations;
  result.converged = found.converged;
  result.stopped_because = found.message;
  result.information = normal.information;
  result.covariance = posterior_covariance(unknowns, normal.information);
  result.fitted_degrees = degrees_of(unknowns, result.covariance);
  result.misfit = normal.misfit;
  result.readings = normal.rows;
  result.noise = objective.noise();
  result.setups = objective.setups();
  result.frame = objective.frame();
  return result;
}

}  // namespace plumbline::identify
