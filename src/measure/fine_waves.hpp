// How fine a grid must be to hold the waves that records hold.
#pragma once

#include <cstddef>
#include <vector>

#include "measure/dataset.hpp"

namespace plumbline::measure {

/// Orders (periods a turn) of which something was found, from the lowest to the highest.
struct OrderRange {
  double lowest = 0;
  double highest = 0;
};

struct FineWaveOptions {
  double first_order = 12;  // of the bands that are looked at, each wider than the one before by
  double wider = 1.12;      // this factor, and at least
  double narrowest = 8;     // so many orders
  double steps_below = 48;  // order up to which reversals say how much they have
  double over_steps = 4;    // times what reversals leave at an order
  double sigmas = 6;        // beyond what independent noise has in common by chance
  double least_um = 1e-3;   // rms of a band; what is less is rounding
  double least_Nm = 1e-4;
};

/// What one channel of runs holds of waves that come again: runs on one circle differ in their noise, whatever its
/// colour, and what they have in common at an order of the circle, Re(a conj b) summed over pairs, is no noise. Steps
/// at reversals have spectra that fall with the square of the order, waves have not. `readings` have a row for each run
/// (N points of a whole turn, by angle); `circles` says which runs were made on one circle (same number). Of runs that
/// are alone on their circle nothing is said.
std::vector<OrderRange> fine_waves(const Eigen::MatrixXd& readings, const std::vector<int>& circles, double least_rms,
                                   const FineWaveOptions& options = {});

/// The least of `points` (ascending) that holds all waves, up to a third as many periods; where none does, the largest
/// into which nothing folds; else the first.
std::size_t points_for(const std::vector<OrderRange>& waves, const std::vector<std::size_t>& points);

}  // namespace plumbline::measure
