// Small displacements of a pose: how they apply, and what lies between two poses. Rotations compose, never add.
#pragma once

#include "machine/geometry.hpp"
#include "machine/orientation.hpp"

namespace plumbline::machine {

/// The pose displaced by (dx, w): the tip by dx (m, in W), the orientation by the rotation vector w (rad, in W):
/// R <- exp(w) R. Any size of w below half a turn.
template <class T>
Pose<T> displaced(const Pose<T>& pose, const Vector6<T>& displacement) {
  const Vector3<T> dx = displacement.template head<3>();
  const Vector3<T> w = displacement.template tail<3>();
  return {pose.p_WT + dx, exponential<T>(w) * pose.R_WP};
}

/// The displacement that leads from one pose to another: displaced(from, displacement_between(from, to)) = to.
template <class T>
Vector6<T> displacement_between(const Pose<T>& from, const Pose<T>& to) {
  Vector6<T> displacement;
  displacement.template head<3>() = to.p_WT - from.p_WT;
  displacement.template tail<3>() = logarithm<T>(to.R_WP * from.R_WP.transpose());
  return displacement;
}

}  // namespace plumbline::machine
