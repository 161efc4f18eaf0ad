#include "identify/prior_strain.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace plumbline::identify {

double PriorStrain::deviate() const {
  if (!(degrees > 0)) return 0;
  const double spread = 2 / (9 * degrees);
  return (std::cbrt(chi2 / degrees) - (1 - spread)) / std::sqrt(spread);
}

double PriorStrain::excess() const { return degrees > 0 ? (chi2 - degrees) / std::sqrt(2 * degrees) : 0; }

double PriorStrain::widening() const { return degrees > 0 ? std::max(1.0, chi2 / degrees) : 1; }

PriorStrain prior_strain(const Eigen::VectorXd& off) { return {off.squaredNorm(), static_cast<double>(off.size())}; }

PriorStrain prior_strain(const Eigen::VectorXd& off, const Eigen::MatrixXd& posterior, double least_share) {
  PriorStrain strain;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(posterior);
  for (Eigen::Index k = 0; k < off.size(); ++k) {
    const double moved = 1 - axes.eigenvalues()[k];
    if (moved < least_share) continue;
    const double along = axes.eigenvectors().col(k).dot(off);
    strain.chi2 += along * along / moved;
    ++strain.degrees;
  }
  return strain;
}

PriorStrain prior_strain(const std::vector<const Unknown*>& unknowns, const Eigen::VectorXd& values,
                         const Eigen::MatrixXd& covariance, double least_share) {
  if (unknowns.empty()) return {};
  Eigen::VectorXd sigmas(values.size());
  Eigen::VectorXd off(values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    const Unknown& unknown = *unknowns[static_cast<std::size_t>(k)];
    sigmas[k] = unknown.sigma;
    off[k] = (values[k] - unknown.start) / unknown.sigma;
  }
  const auto per_sigma = sigmas.cwiseInverse().asDiagonal();
  return prior_strain(off, per_sigma * covariance * per_sigma, least_share);
}

}  // namespace plumbline::identify
