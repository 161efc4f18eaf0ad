// Six equations whose rows are taken in an order found beforehand, for matrices that differ little from one whose best
// order is known: no lane of a pack asks for another one.
#pragma once

#include <array>

#include "machine/lu6.hpp"

namespace plumbline::machine {

/// The order in which partial pivoting takes the rows of A  [Golub and Van Loan, Matrix Computations, 3.4].
using RowOrder = std::array<int, 6>;
RowOrder pivot_order(Matrix6<double> A);

/// L U = A, its rows in the order `rows`, L with ones on its diagonal.
template <class T>
class OrderedLu6 {
 public:
  OrderedLu6(const Matrix6<T>& A, const RowOrder& rows) : rows_(rows) {
    for (int i = 0; i < kSize; ++i) {
      for (int k = 0; k < kSize; ++k) lu_[i][k] = A(rows[static_cast<std::size_t>(i)], k);
    }
    T growth(0.0);
#pragma GCC unroll 6
    for (int k = 0; k < kSize; ++k) {
      inverse_[k] = T(1.0) / lu_[k][k];
#pragma GCC unroll 6
      for (int i = k + 1; i < kSize; ++i) {
        const T factor = lu_[i][k] * inverse_[k];
        lu_[i][k] = factor;
        growth += factor * factor;
#pragma GCC unroll 6
        for (int c = k + 1; c < kSize; ++c) lu_[i][c] -= factor * lu_[k][c];
      }
    }
    sound_ = growth < T(kMostGrowth) && inverse_[5] * inverse_[5] < T(kMostGrowth * kMostGrowth);  // false for NaN
  }

  /// True where no factor has grown so much that the order costs digits: three of sixteen at most. The solutions mean
  /// nothing elsewhere.
  const MaskOf<T>& sound() const { return sound_; }

  /// det A, or -det A where an odd number of exchanges makes the order.
  T determinant() const {
    T product = lu_[0][0];
    for (int k = 1; k < kSize; ++k) product = product * lu_[k][k];
    return product;
  }

  /// x with A x = r.
  Vector6<T> solve(const Vector6<T>& r) const {
    T x[kSize];
    for (int i = 0; i < kSize; ++i) x[i] = r[rows_[static_cast<std::size_t>(i)]];
#pragma GCC unroll 6
    for (int i = 1; i < kSize; ++i) {
#pragma GCC unroll 6
      for (int k = 0; k < i; ++k) x[i] -= lu_[i][k] * x[k];
    }
#pragma GCC unroll 6
    for (int i = kSize - 1; i >= 0; --i) {
#pragma GCC unroll 6
      for (int k = i + 1; k < kSize; ++k) x[i] -= lu_[i][k] * x[k];
      x[i] = x[i] * inverse_[i];
    }
    Vector6<T> solution;
    for (int i = 0; i < kSize; ++i) solution[i] = x[i];
    return solution;
  }

  /// x with A^T x = r.
  Vector6<T> solve_transposed(const Vector6<T>& r) const {
    T x[kSize];
    for (int i = 0; i < kSize; ++i) x[i] = r[i];
#pragma GCC unroll 6
    for (int i = 0; i < kSize; ++i) {
#pragma GCC unroll 6
      for (int k = 0; k < i; ++k) x[i] -= lu_[k][i] * x[k];
      x[i] = x[i] * inverse_[i];
    }
#pragma GCC unroll 6
    for (int i = kSize - 2; i >= 0; --i) {
#pragma GCC unroll 6
      for (int k = i + 1; k < kSize; ++k) x[i] -= lu_[k][i] * x[k];
    }
    Vector6<T> solution;
    for (int i = 0; i < kSize; ++i) solution[rows_[static_cast<std::size_t>(i)]] = x[i];
    return solution;
  }

 private:
  static constexpr int kSize = 6;
  static constexpr double kMostGrowth = 1e6;  // squared factors, all together

  RowOrder rows_;
  T lu_[kSize][kSize];
  T inverse_[kSize];  // of the pivots
  MaskOf<T> sound_;
};

}  // namespace plumbline::machine
