#include "compensate/bound/told_way.hpp"

#include "path/figures.hpp"

namespace plumbline::compensate {

ToldWay::ToldWay(const MovePath& path, const AxisWords& begin, const AxisWords& end, double share,
                 const std::optional<nc::Arc>& arc)
    : begin_(begin), end_(end), per_share_(1 / share) {
  if (!arc) return;
  frame_ = &path.frame;
  nc::Motion motion;
  motion.kind = nc::MotionKind::arc;
  motion.from = frame_->from_pose(begin);
  motion.to = frame_->from_pose(end);
  motion.arc = *arc;
  curve_ = path::Curve(motion);
}

AxisWords ToldWay::pose(double along) const {
  return frame_ == nullptr ? path::between(begin_, end_, along) : frame_->to_pose(curve_.at(along));
}

AxisWords ToldWay::slope(double along) const {
  AxisWords slope = frame_ == nullptr ? end_ - begin_ : frame_->turned(curve_.point(along).slope);
  for (double& value : slope.values) value *= per_share_;
  return slope;
}

}  // namespace plumbline::compensate
