// What several files of this module compute alike.
#pragma once

#include <algorithm>
#include <vector>

#include "base/median.hpp"

namespace plumbline::inspect {

/// The least step between two different values: what is less than that is no difference. nil: all are alike.
inline double resolution(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double least = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step > 1e-12 && (least == 0 || step < least)) least = step;
  }
  return least;
}

}  // namespace plumbline::inspect
