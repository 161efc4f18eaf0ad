// The curve that a motion follows in the control's own axes, by its fraction 0..1.
#pragma once

#include "base/axes.hpp"
#include "nc/control/state/arc_shape.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::path {

/// A point of a curve: its place, and its first and second derivative by the fraction. Work system, mm and deg.
struct CurvePoint {
  AxisWords at, slope, bend;
};

/// A straight line or a helix; the rotary words (and the third axis of a helix) go linearly with the fraction, as the
/// control moves them. A circle whose two radii differ is a spiral, its radius linear in the angle.
class Curve {
 public:
  Curve() = default;  // stays at zero
  explicit Curve(const nc::Motion& motion);

  /// The position at `fraction`; exactly the motion's ends at 0 and 1. Work system, mm and deg.
  AxisWords at(double fraction) const;
  /// The position with its derivatives.
  CurvePoint point(double fraction) const;

  /// Length of the path of X, Y, Z in mm.
  double linear_mm() const { return linear_mm_; }
  /// Length of an arc's circle in its plane, mm; 0 for a line.
  double circle_mm() const;
  /// Angle that an arc sweeps, deg, positive counter-clockwise; 0 for a line.
  double arc_deg() const;
  /// From start to end in each word, mm and deg.
  const AxisWords& delta() const { return delta_; }

 private:
  void set_arc(const nc::Arc& arc);
  AxisWords from_, to_, delta_;
  bool is_arc_ = false;
  nc::PlaneAxes plane_{};
  nc::ArcShape arc_;
  double linear_mm_ = 0;
};

}  // namespace plumbline::path
