#include "identify/observability.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace plumbline::identify {
namespace {

// What the data alone say of a pair, the other unknowns within their priors: the pair's own priors taken back.
Eigen::Matrix2d pair_information(const Fit& fit, std::size_t a, std::size_t b) {
  Eigen::Matrix2d covariance;
  const std::array<std::size_t, 2> pair{a, b};
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      covariance(i, k) = fit.covariance(static_cast<Eigen::Index>(pair[static_cast<std::size_t>(i)]),
                                        static_cast<Eigen::Index>(pair[static_cast<std::size_t>(k)]));
    }
  }
  // the two may differ by many orders of magnitude
  const Eigen::Vector2d scale = covariance.diagonal().cwiseSqrt();
  const Eigen::Matrix2d correlation = (covariance.array() / (scale * scale.transpose()).array()).matrix();
  Eigen::Matrix2d information = correlation.inverse().array() / (scale * scale.transpose()).array();
  for (int i = 0; i < 2; ++i) {
    const double sigma = fit.unknowns[pair[static_cast<std::size_t>(i)]].sigma;
    information(i, i) -= 1 / (sigma * sigma);
  }
  return information;
}

std::vector<Confusion> confusions_of(const Fit& fit, const Observability& known, double apart) {
  const auto unknown_to_data = [&](std::size_t i) {
    return std::find(known.nothing.begin(), known.nothing.end(), i) != known.nothing.end();
  };
  std::vector<Confusion> found;
  for (std::size_t a = 0; a < fit.unknowns.size(); ++a) {
    for (std::size_t b = a + 1; b < fit.unknowns.size(); ++b) {
      if (is_geometry(fit.unknowns[a]) || is_geometry(fit.unknowns[b]) || unknown_to_data(a) || unknown_to_data(b))
        continue;
      const Eigen::Matrix2d M = pair_information(fit, a, b);
      if (M(0, 0) <= 0 || M(1, 1) <= 0) continue;
      const double correlation = -M(0, 1) / std::sqrt(M(0, 0) * M(1, 1));
      if (!(std::abs(correlation) >= apart)) continue;
      // w a + b moves as the data see it: along its gradient, w = M01 / M11; its variance with the priors
      Confusion c{a, b, correlation, M(0, 1) / M(1, 1)};
      const auto i = static_cast<Eigen::Index>(a);
      const auto k = static_cast<Eigen::Index>(b);
      c.value = c.weight * fit.values[i] + fit.values[k];
      c.standard_error = std::sqrt(c.weight * c.weight * fit.covariance(i, i) + 2 * c.weight * fit.covariance(i, k) +
                                   fit.covariance(k, k));
      found.push_back(c);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Confusion& a, const Confusion& b) { return std::abs(a.correlation) > std::abs(b.correlation); });
  return found;
}

MeasuredAt measured_at(const std::vector<measure::Run>& runs, double one_height) {
  if (runs.empty()) return MeasuredAt::poses;
  const auto [lowest, highest] = std::minmax_element(
      runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.centre_W.z() < b.centre_W.z(); });
  return highest->centre_W.z() - lowest->centre_W.z() <= one_height ? MeasuredAt::circles_at_one_height
                                                                    : MeasuredAt::circles;
}

}  // namespace

Observability observability(const Fit& fit, const std::vector<measure::Run>& runs,
                            const ObservabilityOptions& options) {
  Observability found;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(fit.information, Eigen::EigenvaluesOnly);
  found.singular_values = eigen.eigenvalues().cwiseMax(0).cwiseSqrt().reverse();
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& unknown = fit.unknowns[i];
    if (unknown.free()) {
      if (!std::isfinite(fit.standard_error(i))) found.nothing.push_back(i);
    } else if (fit.standard_error(i) > options.little * unknown.sigma) {
      found.little.push_back(i);
    }
  }
  found.confusions = confusions_of(fit, found, options.apart);
  found.measured_at = measured_at(runs, options.one_height);
  return found;
}

std::optional<ShownGeometry> shown_geometry(const machine::Geometry& geometry, const Unknowns& unknowns,
                                            const Eigen::MatrixXd& covariance, const ObservabilityOptions& options) {
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    if (is_geometry(unknowns[i]) && !unknowns[i].free()) places.push_back(static_cast<Eigen::Index>(i));
  }
  if (places.empty()) return std::nullopt;
  Eigen::MatrixXd of_priors = covariance(places, places);
  for (Eigen::Index i = 0; i < of_priors.rows(); ++i) {
    const double sigma = unknowns[static_cast<std::size_t>(places[static_cast<std::size_t>(i)])].sigma;
    of_priors.row(i) /= sigma;
    of_priors.col(i) /= sigma;
  }
  const Eigen::VectorXd shares =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(of_priors, Eigen::EigenvaluesOnly).eigenvalues();
  ShownGeometry shown{
      places.size(), static_cast<std::size_t>((shares.array() < options.better * options.better).count()), {}};
  for (WholeMotion& motion : whole_motions(geometry, unknowns)) {
    if (left_of_prior(motion, unknowns, covariance) > options.little) shown.hidden.push_back(std::move(motion));
  }
  return shown;
}

}  // namespace plumbline::identify
