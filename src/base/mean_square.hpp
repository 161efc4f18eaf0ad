// Root of the mean square of numbers that come one by one, or many at once.
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace plumbline {

struct MeanSquare {
  double sum = 0;  // of squares
  Eigen::Index count = 0;

  void add(double value) {
    sum += value * value;
    ++count;
  }
  template <class Numbers>
  void add(const Eigen::MatrixBase<Numbers>& values) {
    sum += values.squaredNorm();
    count += values.size();
  }
  void add(const MeanSquare& other) {
    sum += other.sum;
    count += other.count;
  }
  /// Zero of no numbers, as is its root.
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
  double root() const { return std::sqrt(mean()); }
};

}  // namespace plumbline
