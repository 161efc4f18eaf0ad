#include "compensate/move.hpp"

namespace plumbline::compensate {

AxisWords MovePath::in_base_frame(AxisWords work) const {
  for (const Axis axis : kAllAxes) {
    if (at_zero.contains(axis)) work[axis] = 0;
  }
  return frame.to_pose(work);
}

Target MovePath::target(const path::CurvePoint& point, std::optional<double> seconds) const {
  return {in_base_frame(point.at) + added, frame.turned(point.slope), frame.turned(point.bend), seconds, fixed};
}

Target MovePath::at_rest(const AxisWords& work) const {
  return {in_base_frame(work) + added, {}, {}, std::nullopt, fixed};
}

}  // namespace plumbline::compensate
