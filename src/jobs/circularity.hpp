// The figures of ISO 230-4 of every run of a dataset, and of every pair that differs in direction alone.
#pragma once

#include <string>
#include <vector>

#include "measure/circularity.hpp"

namespace plumbline::jobs {

struct RunCircularity {
  std::string id;
  measure::CircularityFigures figures;
  std::vector<measure::Harmonic> harmonics;  // of order 1 to 8
};

struct PairCircularity {
  std::string ccw, cw;  // ids
  measure::BidirectionalFigures figures;
};

struct CircularityTable {
  std::vector<RunCircularity> runs;    // those with readings of the bar
  std::vector<PairCircularity> pairs;  // a run is in one pair at most: with the next one that fits
};

CircularityTable circularity_table(const measure::Dataset& dataset);

}  // namespace plumbline::jobs
