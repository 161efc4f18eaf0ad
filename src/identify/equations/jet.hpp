// Numbers that carry their derivatives, and what the physics needs to calculate with them fast. To be included before
// the physics is used with such numbers.
#pragma once

#include <ceres/jet.h>

#include "machine/lu6.hpp"

namespace plumbline::identify {

/// Six derivatives at a time: a pose, or one number for each strut.
inline constexpr int kSeeds = 6;
using Jet = ceres::Jet<double, kSeeds>;

/// The derivatives of a vector of such numbers, one row for each.
template <int Rows>
Eigen::Matrix<double, Rows, kSeeds> slopes_of(const Eigen::Matrix<Jet, Rows, 1>& values) {
  Eigen::Matrix<double, Rows, kSeeds> slopes;
  for (int i = 0; i < Rows; ++i) slopes.row(i) = values[i].v.transpose();
  return slopes;
}

}  // namespace plumbline::identify

namespace plumbline::machine {

/// Linear systems of numbers with derivatives: the values are factorised once, the derivatives follow from
/// A x = r:  A dx = dr - dA x  [implicit function theorem].
template <int N>
class Lu6<ceres::Jet<double, N>> {
 public:
  using T = ceres::Jet<double, N>;

  explicit Lu6(const Matrix6<T>& A, double relative_pivot = 1e-13) : A_(A), values_(value_of(A), relative_pivot) {}

  bool singular() const { return values_.singular(); }
  /// Its value alone: what is asked of it is the sign.
  T determinant() const { return T(values_.determinant()); }

  Vector6<T> solve(const Vector6<T>& r) const {
    return solve_as(A_, r, [&](const Vector6<double>& b) { return values_.solve(b); });
  }
  Vector6<T> solve_transposed(const Vector6<T>& r) const {
    return solve_as(A_.transpose(), r, [&](const Vector6<double>& b) { return values_.solve_transposed(b); });
  }

 private:
  static Matrix6<double> value_of(const Matrix6<T>& A) {
    Matrix6<double> values;
    for (int i = 0; i < 36; ++i) values(i) = A(i).a;
    return values;
  }

  template <class Derived, class Solve>
  static Vector6<T> solve_as(const Eigen::MatrixBase<Derived>& A, const Vector6<T>& r, Solve&& solve) {
    Vector6<double> right;
    for (int i = 0; i < 6; ++i) right[i] = r[i].a;
    const Vector6<double> x = solve(right);
    Eigen::Matrix<double, 6, N> rest;
    for (int i = 0; i < 6; ++i) {
      rest.row(i) = r[i].v.transpose();
      for (int k = 0; k < 6; ++k) rest.row(i) -= x[k] * A(i, k).v.transpose();
    }
    Eigen::Matrix<double, 6, N> slopes;
    for (int k = 0; k < N; ++k) slopes.col(k) = solve(rest.col(k));
    Vector6<T> solution;
    for (int i = 0; i < 6; ++i) solution[i] = T(x[i], slopes.row(i).transpose());
    return solution;
  }

  Matrix6<T> A_;
  Lu6<double> values_;
};

}  // namespace plumbline::machine
