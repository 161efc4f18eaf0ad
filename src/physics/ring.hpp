// Rings of joints, for effects that need to know how a universal joint is built in.
#pragma once

#include <Eigen/Geometry>

#include "base/pose.hpp"

namespace plumbline::physics {

/// The direction along the ring on which a joint sits, the ring being about Z: taken for the outer axis of a universal
/// joint. Along Y for a joint on Z itself.
inline Vector3<double> along_ring(const Vector3<double>& joint) {
  const Vector3<double> outward(joint.x(), joint.y(), 0);
  return outward.isZero() ? Vector3<double>::UnitY() : Vector3<double>::UnitZ().cross(outward.normalized());
}

}  // namespace plumbline::physics
