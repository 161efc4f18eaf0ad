#include "machine/condition.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace plumbline::machine {
namespace {

constexpr int kSquarings = 4;
constexpr double kClearRatio = 1e6;  // of eigenvalues of J^T J: up to there their ratio has ten digits
constexpr double kRounding = 2e-14;  // of J^T J and of its factorisation, in parts of the largest eigenvalue

// Never below the largest eigenvalue of a positive definite A, and at most 6 % above it: s <= |A^m|^(1/m) <= 6^(1/2m) s
// in the Frobenius norm, with m = 2^kSquarings.
double largest_eigenvalue_ceiling(const Matrix6<double>& A) {
  const double size = A.norm();
  Matrix6<double> power = A / size;
  for (int i = 0; i < kSquarings; ++i) power = (power * power).eval();
  double root = power.norm();
  for (int i = 0; i < kSquarings; ++i) root = std::sqrt(root);
  return size * root;
}

}  // namespace

// The squared condition number is the ratio of the eigenvalues of A = J^T J. None of them is below t where A - t 1 has
// a Cholesky factorisation.
bool condition_surely_below(const StrutGeometry<double>& struts, double radius, double most) {
  const Matrix6<double> J = scaled_jacobian(struts, radius);
  Matrix6<double> A = J.transpose() * J;
  const double least = largest_eigenvalue_ceiling(A) * (1 / (most * most) + kRounding);
  A.diagonal().array() -= least;
  return Eigen::LLT<Matrix6<double>>(A).info() == Eigen::Success;
}

double condition_number(const StrutGeometry<double>& struts, double radius) {
  const Matrix6<double> J = scaled_jacobian(struts, radius);
  const Eigen::SelfAdjointEigenSolver<Matrix6<double>> squares(J.transpose() * J, Eigen::EigenvaluesOnly);
  const double ratio = squares.eigenvalues()[kStruts - 1] / squares.eigenvalues()[0];
  if (ratio > 0 && ratio < kClearRatio) return std::sqrt(ratio);
  const Eigen::JacobiSVD<Matrix6<double>> svd(J);
  const double least = svd.singularValues()[kStruts - 1];
  return least > 0 ? svd.singularValues()[0] / least : std::numeric_limits<double>::infinity();
}

}  // namespace plumbline::machine
