#include "identify/prior_strain.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace plumbline::identify {

double PriorStrain::deviate() const {
  if (!(degrees > 0)) return 0;
  const double spread = 2 / (9 * degrees);
  return (std::cbrt(chi2 / degrees) - (1 - spread)) / std::sqrt(spread);
}

double PriorStrain::excess() const { return degrees > 0 ? (chi2 - degrees) / std::sqrt(2 * degrees) : 0; }

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

PriorStrain prior_strain(const Eigen::VectorXd& moved, const Eigen::VectorXd& sigmas, const Eigen::MatrixXd& covariance,
                         double least_share) {
  const auto per_sigma = sigmas.cwiseInverse().asDiagonal();
  return prior_strain(per_sigma * moved, per_sigma * covariance * per_sigma, least_share);
}

}  // namespace plumbline::identify
