// How the control goes over a piece of the output, as it is told: straight in all axes, or along an arc.
#pragma once

#include <optional>

#include "base/axes.hpp"
#include "compensate/move.hpp"
#include "nc/control/state/motion.hpp"
#include "path/curve.hpp"

namespace plumbline::compensate {

class ToldWay {
 public:
  /// From pose to pose in W (mm, deg) over a share of the block; `arc`, in the work system of `path`: along it.
  ToldWay(const MovePath& path, const AxisWords& begin, const AxisWords& end, double share,
          const std::optional<nc::Arc>& arc);

  /// The pose that the control is told, in W, and its slope by the fraction of the block.
  AxisWords pose(double along) const;
  AxisWords slope(double along) const;

 private:
  const nc::Frame* frame_ = nullptr;  // of an arc
  path::Curve curve_;                 // in the work system
  AxisWords begin_, end_;
  double per_share_ = 1;
};

}  // namespace plumbline::compensate
