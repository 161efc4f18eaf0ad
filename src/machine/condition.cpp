#include "machine/condition.hpp"

#include <cmath>
#include <limits>

#include <Eigen/SVD>

namespace plumbline::machine {
namespace {

constexpr int kSquarings = 4;
constexpr double kRounding = 1 + 1e-12;

// s1 <= |(A^T A)^m|^(1 / 2m) <= 6^(1 / 4m) s1 in the Frobenius norm, s1 the largest singular value of A; m = 16.
double largest_from_above(const Matrix6<double>& A) {
  Matrix6<double> power = A.transpose() * A;
  double exponent = 1;
  double logarithm = 0;  // of what the powers were divided by, as a factor of A^T A
  for (int squaring = 0; squaring < kSquarings; ++squaring) {
    const double size = power.norm();
    logarithm += std::log(size) / exponent;
    power /= size;
    power = (power * power).eval();
    exponent *= 2;
  }
  logarithm += std::log(power.norm()) / exponent;
  return std::exp(0.5 * logarithm) * kRounding;
}

}  // namespace

double condition_ceiling(const StrutGeometry<double>& struts, double radius) {
  const Matrix6<double> J = scaled_jacobian(struts, radius);
  const Lu6<double> lu(J);
  if (lu.singular()) return std::numeric_limits<double>::infinity();
  Matrix6<double> inverse;
  for (int j = 0; j < kStruts; ++j) inverse.col(j) = lu.solve(Vector6<double>::Unit(j));
  return largest_from_above(J) * largest_from_above(inverse);
}

double condition_number(const StrutGeometry<double>& struts, double radius) {
  const Eigen::JacobiSVD<Matrix6<double>> svd(scaled_jacobian(struts, radius));
  const double least = svd.singularValues()[kStruts - 1];
  return least > 0 ? svd.singularValues()[0] / least : std::numeric_limits<double>::infinity();
}

}  // namespace plumbline::machine
