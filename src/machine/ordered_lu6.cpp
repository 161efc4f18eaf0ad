#include "machine/ordered_lu6.hpp"

#include <cmath>
#include <utility>

namespace plumbline::machine {

RowOrder pivot_order(Matrix6<double> A) {
  RowOrder rows{0, 1, 2, 3, 4, 5};
  for (int k = 0; k < 6; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 6; ++i) {
      if (std::abs(A(i, k)) > std::abs(A(pivot, k))) pivot = i;
    }
    A.row(k).swap(A.row(pivot));
    std::swap(rows[static_cast<std::size_t>(k)], rows[static_cast<std::size_t>(pivot)]);
    if (A(k, k) == 0) continue;  // singular: no order helps
    for (int i = k + 1; i < 6; ++i) A.row(i) -= A(i, k) / A(k, k) * A.row(k);
  }
  return rows;
}

}  // namespace plumbline::machine
