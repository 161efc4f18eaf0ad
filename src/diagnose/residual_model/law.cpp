#include "diagnose/residual_model/law.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace plumbline::diagnose {
namespace {

constexpr int kPoints = 101;          // of a region
constexpr double kLeastTold = 1e-3;   // of a direction of the weights, as what was known of it: less says nothing
constexpr double kOfInterval = 3.84;  // chi-square of one number, 95 %

// Those of numbers that hardly count are no zeros to divide by.
Eigen::VectorXd sigmas_of(const Component& component) {
  return component.sigmas.cwiseMax(1e-12 * component.sigmas.maxCoeff());
}

// What the readings alone say of the weights in their sigmas: chi-square = (w - w_0)^T L (w - w_0), L diagonal along
// `axes`, pull = L w_0.
struct Told {
  Eigen::MatrixXd axes;
  Eigen::VectorXd precision, pull;
  double chi_square = 0;  // of none at all

  Told(const Component& of, const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd inverse = sigmas_of(of).cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> after(inverse.asDiagonal() * covariance *
                                                               inverse.asDiagonal());
    axes = after.eigenvectors();
    const Eigen::VectorXd along = axes.transpose() * inverse.cwiseProduct(of.weights);
    precision = Eigen::VectorXd::Zero(along.size());
    pull = precision;
    for (Eigen::Index i = 0; i < along.size(); ++i) {
      const double variance = after.eigenvalues()[i];
      if (variance <= 0 || 1 / variance - 1 < kLeastTold) continue;
      precision[i] = 1 / variance - 1;
      pull[i] = along[i] / variance;
      chi_square += pull[i] * pull[i] / precision[i];
    }
  }
};

// What the power is of, in the unit of PowerLaw, where the coordinate is `at`.
double base_of(int coordinate, double at, const physics::MachineConstants& machine) {
  if (coordinate != coordinates::kLength) return at;
  return 1 + at * kCoordinateLength / machine.middle_length.mean();
}

// The weights, in their sigmas, of functions that come nearest to powers over the region.
class Powers {
 public:
  Powers(const Component& of, const physics::MachineConstants& machine) : sigmas_(sigmas_of(of)), x_(kPoints) {
    Eigen::MatrixXd functions(kPoints, of.shape.functions());
    const double lower = of.region.middle[0] - of.region.half_width[0];
    for (int i = 0; i < kPoints; ++i) {
      const double at = lower + 2 * of.region.half_width[0] * i / (kPoints - 1);
      functions.row(i) = functions_at(of.shape, of.region, {at});
      x_[i] = base_of(of.shape.coordinates[0], at, machine);
    }
    nearest_.compute(functions);
  }

  Eigen::VectorXd weights(double exponent) const {
    const Eigen::VectorXd power =
        x_.unaryExpr([&](double x) { return std::copysign(std::pow(std::abs(x), exponent), x); });
    return nearest_.solve(power).cwiseQuotient(sigmas_);
  }

 private:
  Eigen::VectorXd sigmas_, x_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> nearest_;
};

}  // namespace

std::optional<PowerLaw> power_law_of(const Component& component, const Eigen::MatrixXd& covariance,
                                     const physics::MachineConstants& machine, const LawOptions& options) {
  const Shape& shape = component.shape;
  if (shape.coordinates.size() != 1 || component.parts != std::vector<int>{-1}) return std::nullopt;
  const int of = shape.coordinates[0];
  if (of != coordinates::kLength && of != coordinates::kSpeed && of != coordinates::kTension) return std::nullopt;
  const Told told(component, covariance);
  if (told.chi_square < options.least_strength) return std::nullopt;
  const Powers powers(component, machine);
  const auto count = static_cast<int>(std::lround((options.most_exponent - options.least_exponent) / options.step)) + 1;
  std::vector<double> left(static_cast<std::size_t>(count));
  PowerLaw law;
  double least = told.chi_square;
  const auto exponent_of = [&](int k) { return options.least_exponent + k * options.step; };
  for (int k = 0; k < count; ++k) {
    const Eigen::VectorXd along = told.axes.transpose() * powers.weights(exponent_of(k));
    const double precision = along.dot(told.precision.cwiseProduct(along));
    const double size = along.dot(told.pull) / precision;
    left[static_cast<std::size_t>(k)] = told.chi_square - size * size * precision;
    if (left[static_cast<std::size_t>(k)] >= least) continue;
    least = left[static_cast<std::size_t>(k)];
    law = {size, 1 / std::sqrt(precision), exponent_of(k), 0, 0};
  }
  if (least > (1 - options.least_share) * told.chi_square) return std::nullopt;
  // what no power takes counts as so much more noise
  const double freedom = std::max<double>(static_cast<double>((told.precision.array() > 0).count()) - 2, 1);
  const double within = least + kOfInterval * std::max(1.0, least / freedom);
  int first = count;
  int last = -1;
  for (int k = 0; k < count; ++k) {
    if (left[static_cast<std::size_t>(k)] > within) continue;
    first = std::min(first, k);
    last = std::max(last, k);
  }
  law.least = exponent_of(first);
  law.most = exponent_of(last);
  if (law.most - law.least > options.widest || first == 0 || last == count - 1) return std::nullopt;
  return law;
}

}  // namespace plumbline::diagnose
