// A long record brought to an even grid of angle by least squares: what the grid cannot hold does not fold into it.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "measure/dataset.hpp"

namespace plumbline::measure {

/// Meyer's scaling function phi at x, in steps of the grid [Meyer 1992]: phi and its shifts by whole steps are
/// orthonormal, so that products with it are the least-squares projection on what they span. In cycles per step its
/// spectrum is 1 below 1/3 and 0 above 2/3, |.|^2 being symmetric about 1/2 between. Cut off at kMeyerReach.
double meyer(double x);
inline constexpr int kMeyerReach = 10;  // steps; what is cut off is less than 4e-4 of any wave

/// Readings of one run, a column for each sample.
using SampleColumns = Eigen::MatrixXd;

/// The projection of one run's samples on a grid of so many points of a whole turn, which begins at angle zero.
///
/// A wave of k periods a turn stays as it is for k < points / 3 and is gone for k > points * 2 / 3; between, its size
/// falls, and what folds is |phi|^2 in power, so that white noise of samples (sigma, every d of angle) is white noise
/// of points: sigma sqrt(d / step). Samples count by the angle that they stand for, so that they need not be even. Of a
/// whole turn, the end goes on with the start; of less, the points within kMeyerReach steps of the ends are left out.
/// What steps or drifts has ripples where it does so, the same as whatever goes with it has: signs, time.
class EvenGrid {
 public:
  EvenGrid(const Run& run, std::size_t points);

  /// False: samples are too far apart for that many points, or fewer than `least` would be left.
  bool possible() const { return possible_; }
  bool whole_turn() const { return whole_turn_; }
  /// Of each point: 0 up to a turn, as `Run::angle`.
  std::vector<double> angles() const;
  /// The columns of the points: rows as in `samples`.
  Eigen::MatrixXd project(const SampleColumns& samples) const;

  static constexpr std::size_t kFewest = 24;

 private:
  double turn_ = 1;             // +1 counterclockwise
  std::size_t points_ = 0;      // of a whole turn
  std::vector<double> at_;      // of each sample: steps of the grid along the way
  std::vector<double> stands_;  // for so many steps
  long first_ = 0;              // point, from angle zero
  std::size_t count_ = 0;       // of points
  bool whole_turn_ = false;
  bool possible_ = false;
};

}  // namespace plumbline::measure
