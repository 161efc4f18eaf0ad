#include "machine/condition.hpp"

#include <cmath>
#include <limits>

#include <Eigen/SVD>

namespace plumbline::machine {
namespace {

constexpr int kSquarings = 4;
constexpr double kRounding = 1 + 1e-12;

// s1 <= |(A^T A)^m|^(1 / 2m) <= 6^(1 / 4m) s1 in the Frobenius norm, s1 the largest singular value of A: for m = 1, 2,
// 4...
class LargestFromAbove {
 public:
  explicit LargestFromAbove(const Matrix6<double>& A) : power_(A.transpose() * A) {}

  double next() {
    if (exponent_ > 0) {
      power_ /= size_;
      power_ = (power_ * power_).eval();
    }
    exponent_ = exponent_ > 0 ? 2 * exponent_ : 1;
    size_ = power_.norm();
    logarithm_ += std::log(size_) / exponent_;
    return std::exp(0.5 * logarithm_) * kRounding;
  }

 private:
  Matrix6<double> power_;
  double size_ = 0, exponent_ = 0;
  double logarithm_ = 0;  // of what the powers were divided by, as a factor of A^T A
};

}  // namespace

double condition_ceiling(const StrutGeometry<double>& struts, double radius, double enough) {
  const Matrix6<double> J = scaled_jacobian(struts, radius);
  const Lu6<double> lu(J);
  if (lu.singular()) return std::numeric_limits<double>::infinity();
  Matrix6<double> inverse;
  for (int j = 0; j < kStruts; ++j) inverse.col(j) = lu.solve(Vector6<double>::Unit(j));
  LargestFromAbove forth(J);
  LargestFromAbove back(inverse);
  double ceiling = forth.next() * back.next();
  for (int squaring = 0; squaring < kSquarings && ceiling > enough; ++squaring) ceiling = forth.next() * back.next();
  return ceiling;
}

double condition_number(const StrutGeometry<double>& struts, double radius) {
  const Eigen::JacobiSVD<Matrix6<double>> svd(scaled_jacobian(struts, radius));
  const double least = svd.singularValues()[kStruts - 1];
  return least > 0 ? svd.singularValues()[0] / least : std::numeric_limits<double>::infinity();
}

}  // namespace plumbline::machine
