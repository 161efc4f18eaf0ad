// How far the deformed tip is from a path when the control stands off the correction.
#pragma once

#include "base/axes.hpp"
#include "compensate/corrector.hpp"
#include "compensate/target.hpp"

namespace plumbline::compensate {

/// From the path that the original asks for, in W.
struct Deviation {
  double tip_mm = 0;
  double turned_rad = 0;
};

/// A control that stands `off` (mm, deg) the command that puts the tip on the target: the tip is `off` the target
/// itself, since the correction hardly changes over some micrometres. Of X, Y and Z only what leads away from the path
/// counts: n = e - t (t . e), with k |t . e|^2 / 2 for the path's own curvature k, and what leads beyond one of its
/// ends, which the fraction 0..1 of the target says. A, B and C count as the angle between the orientations.
Deviation deviation(const Corrector& corrector, const Target& target, double fraction, const AxisWords& off);

}  // namespace plumbline::compensate
