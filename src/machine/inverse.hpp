// Inverse kinematics: from the pose of the tool to the struts, in closed form.
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "base/scalar.hpp"
#include "machine/geometry.hpp"

namespace plumbline::machine {

/// The struts at a pose, all in W.
template <class T>
struct StrutGeometry {
  StrutVectors<T> arm;        // b_j, from the tip to the platform joint, m
  StrutVectors<T> direction;  // u_j, unit vector from the base joint to the platform joint
  PerStrut<T> length;         // L_j, m
};

/// p_j - c: from the tip to the platform joints, m in P.
inline StrutVectors<double> arms_of(const Geometry& geometry) {
  return geometry.platform_joints_P.colwise() - geometry.tool_tip_P;
}

/// b_j = R (p_j - c), d_j = x + b_j - q_j, L_j = |d_j|, u_j = d_j / L_j  [Ibaraki et al., Eq. 1-2; docs/physics.md]
/// A strut of length zero gives u_j that is not finite; geometries in which that can happen are refused by the reader
/// of models.
/// `arms_P` are arms_of(geometry).
template <class T>
StrutGeometry<T> strut_geometry(const Geometry& geometry, const StrutVectors<double>& arms_P, const Pose<T>& pose) {
  using std::sqrt;
  StrutGeometry<T> struts;
  for (int j = 0; j < kStruts; ++j) {
    const Vector3<T> b = pose.R_WP * arms_P.col(j).template cast<T>();
    const Vector3<T> d = pose.p_WT + b - geometry.base_joints_W.col(j).template cast<T>();
    const T length = sqrt(d.squaredNorm());
    struts.arm.col(j) = b;
    struts.direction.col(j) = d * (T(1.0) / length);
    struts.length[j] = length;
  }
  return struts;
}

template <class T>
StrutGeometry<T> strut_geometry(const Geometry& geometry, const Pose<T>& pose) {
  return strut_geometry(geometry, arms_of(geometry), pose);
}

/// The strut lengths (m) that the controller commands for a pose.
template <class T>
PerStrut<T> strut_lengths(const Geometry& geometry, const Pose<T>& pose) {
  return strut_geometry(geometry, pose).length;
}

}  // namespace plumbline::machine
