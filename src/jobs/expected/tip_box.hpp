// How far the tip may be from where a model has it, over a box of the workspace: what plans for the tip are made by.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/axes.hpp"
#include "identify/equations/sensitivity.hpp"
#include "machine/model.hpp"

namespace plumbline::jobs {

struct TipBoxOptions {
  std::array<std::optional<machine::Range>, 3> box;  // m; an axis without one: the middle half of the model's travel
  std::vector<double> tilts{0};  // rad; the platform is tilted so far to all four sides, about A and about B
  std::size_t points = 5;        // along each side of the box, its ends among them
};

/// Of poses of the box: 1 sigma of the tip, the root of the variances along X, Y and Z summed, m.
struct TipFigures {
  double rms = 0;
  double worst = 0;
  AxisWords worst_at;  // mm, deg
};
struct TipOverBox {
  TipFigures stands;
  TipFigures touched_off;  // the zero touched off in the middle of the box, not tilted
};

/// The slopes of the tip at poses of a box, the machine at rest, without friction: as `map` has its uncertainty.
class TipBox {
 public:
  /// Refuses with plan-box what is no box and no tilt, or lies further out than any machine, tilts and boxes of which
  /// the machine reaches nothing, and a middle where it cannot stand.
  TipBox(const machine::MachineModel& model, const identify::Unknowns& unknowns, const TipBoxOptions& options);

  /// With that covariance of the unknowns, SI: the variance at a pose is the trace of S C S^T, touched off with the
  /// difference of the slopes.
  TipOverBox with(const Eigen::MatrixXd& covariance) const;
  /// The mean of S^T S over the poses, SI: the mean variance of the tip is the trace of its product with a covariance.
  /// As the tip stands, and with the zero touched off.
  const Eigen::MatrixXd& mean_square() const { return mean_square_; }
  const Eigen::MatrixXd& mean_square_touched_off() const { return mean_square_touched_off_; }

  const std::array<machine::Range, 3>& box() const { return box_; }  // m
  std::size_t poses() const { return poses_; }
  std::size_t reached() const { return places_.size(); }

 private:
  struct Place {
    AxisWords pose;
    Eigen::Matrix3Xd slopes;
  };

  std::array<machine::Range, 3> box_;
  std::size_t poses_ = 0;
  std::vector<Place> places_;
  Eigen::Matrix3Xd middle_;
  Eigen::MatrixXd mean_square_, mean_square_touched_off_;
};

}  // namespace plumbline::jobs
