// The one solver of linear systems on the hot path: six equations, LU with partial pivoting, for every scalar. Packs
// pivot lane by lane without a branch.
#pragma once

#include <array>
#include <cstddef>

#include "base/scalar.hpp"
#include "machine/geometry.hpp"

namespace plumbline::machine {

/// P A = L U, L with ones on its diagonal  [Golub and Van Loan, Matrix Computations, 3.4]. One factorisation serves A x
/// = r and A^T x = r.
template <class T>
class Lu6 {
 public:
  using Mask = MaskOf<T>;

  /// Where a pivot falls below `relative_pivot` times the largest entry of A, the matrix counts as singular.
  explicit Lu6(const Matrix6<T>& A, double relative_pivot = 1e-13) : lu_(A) {
    T largest = T(0.0);
    for (int i = 0; i < kSize; ++i) {
      for (int k = 0; k < kSize; ++k) largest = larger<T>(largest, absolute<T>(A(i, k)));
    }
    const T least = largest * T(relative_pivot);
    for (int k = 0; k < kSize; ++k) {
      pivot(k);
      const Mask bad = !(absolute<T>(lu_(k, k)) > least);  // true for NaN as well
      singular_ = k == 0 ? bad : (singular_ || bad);
      inverse_[at(k)] = select<T>(bad, T(0.0), T(1.0) / select<T>(bad, T(1.0), lu_(k, k)));
      for (int i = k + 1; i < kSize; ++i) eliminate(i, k);
    }
  }

  /// True (per lane) if A is singular. The solutions are then finite but meaningless: ask before using them.
  Mask singular() const { return singular_; }

  /// det A; its sign tells on which side of a singularity a machine stands.
  T determinant() const {
    T product = odd_;
    for (int k = 0; k < kSize; ++k) product = product * lu_(k, k);
    return product;
  }

  /// x with A x = r.
  Vector6<T> solve(const Vector6<T>& r) const {
    Vector6<T> x = r;
    for (int k = 0; k < kSize; ++k) {
      for (int i = k + 1; i < kSize; ++i) swap_where<T>(swapped(k, i), x[k], x[i]);
    }
    for (int i = 1; i < kSize; ++i) {
      for (int k = 0; k < i; ++k) x[i] -= lu_(i, k) * x[k];
    }
    for (int i = kSize - 1; i >= 0; --i) {
      for (int k = i + 1; k < kSize; ++k) x[i] -= lu_(i, k) * x[k];
      x[i] = x[i] * inverse_[at(i)];
    }
    return x;
  }

  /// x with A^T x = r.
  Vector6<T> solve_transposed(const Vector6<T>& r) const {
    // A^T = U^T L^T P: forward through U^T, back through L^T, then the exchanges undone in reverse order
    Vector6<T> x = r;
    for (int i = 0; i < kSize; ++i) {
      for (int k = 0; k < i; ++k) x[i] -= lu_(k, i) * x[k];
      x[i] = x[i] * inverse_[at(i)];
    }
    for (int i = kSize - 2; i >= 0; --i) {
      for (int k = i + 1; k < kSize; ++k) x[i] -= lu_(k, i) * x[k];
    }
    for (int k = kSize - 1; k >= 0; --k) {
      for (int i = kSize - 1; i > k; --i) swap_where<T>(swapped(k, i), x[k], x[i]);
    }
    return x;
  }

 private:
  static constexpr int kSize = 6;
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
  Mask swapped(int k, int i) const { return swapped_[at(k)][at(i)]; }

  // Brings the largest entry of column k, from row k down, into row k: each row below that is larger changes places.
  void pivot(int k) {
    for (int i = k + 1; i < kSize; ++i) {
      const Mask mask = absolute<T>(lu_(k, k)) < absolute<T>(lu_(i, k));
      swapped_[at(k)][at(i)] = mask;
      if (!any(mask)) continue;
      for (int c = 0; c < kSize; ++c) swap_where<T>(mask, lu_(k, c), lu_(i, c));
      odd_ = select<T>(mask, -odd_, odd_);
    }
  }

  void eliminate(int i, int k) {
    const T factor = lu_(i, k) * inverse_[at(k)];
    lu_(i, k) = factor;
    for (int c = k + 1; c < kSize; ++c) lu_(i, c) -= factor * lu_(k, c);
  }

  Matrix6<T> lu_;
  std::array<T, kSize> inverse_;  // of the pivots
  std::array<std::array<Mask, kSize>, kSize> swapped_;
  Mask singular_;
  T odd_ = T(1.0);  // -1 after an odd number of exchanges
};

}  // namespace plumbline::machine
