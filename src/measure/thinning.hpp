// Long records made short: consecutive samples averaged.
#pragma once

#include <vector>

#include "measure/dataset.hpp"

namespace plumbline::measure {

struct ThinningOptions {
  std::size_t enough = 360;  // samples of a turn that tell all that a model of the machine says of it
};

/// What became of records that were longer than a fit needs.
struct Thinning {
  std::size_t runs = 0;     // how many there are
  std::size_t thinned = 0;  // how many of them were
  std::size_t largest = 1;  // most samples that one mean is made of
  std::size_t longest = 0;  // samples of the longest record
};

struct Thinned {
  std::vector<Run> runs;
  Thinning thinning;
};

/// Runs of twice `enough` samples and more: means of so many consecutive samples each that `enough` are left, of time,
/// angle and readings alike; the last mean may be of fewer. White noise of a mean of k is that of a sample divided by
/// the root of k; noise that remembers longer stays. A wave of ten periods a turn loses 0.1 % of its size.
Thinned thinned(std::vector<Run> runs, const ThinningOptions& options = {});

}  // namespace plumbline::measure
