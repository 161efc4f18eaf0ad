// How numbers that come one by one are spread, without keeping them.
#pragma once

#include <cstdint>
#include <vector>

namespace plumbline::jobs {

/// Least, largest and shares of positive numbers. Counts them in classes that are half a percent wide.
class Spread {
 public:
  void add(double value);
  std::uint64_t count() const { return count_; }
  double least() const { return least_; }
  double largest() const { return largest_; }
  /// A number that at least that share (0 to 1) of all do not exceed: no less than the smallest such, at most half a
  /// percent above it. 0 if there are none.
  double bound_of(double share) const;

 private:
  std::vector<std::uint64_t> classes_;
  std::uint64_t count_ = 0;
  double least_ = 0;
  double largest_ = 0;
};

}  // namespace plumbline::jobs
