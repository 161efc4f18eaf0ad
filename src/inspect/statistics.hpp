// What several files of this module compute alike.
#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

namespace plumbline::inspect {

inline constexpr double kTurn = 2 * std::numbers::pi;

/// The greater of the middle ones of an even number; there is at least one.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace plumbline::inspect
