// The kinematic part of a machine: where its joints are.
#pragma once

#include <Eigen/Core>

#include "base/pose.hpp"

namespace plumbline::machine {

inline constexpr int kStruts = 6;

/// One number per strut, one vector per strut.
template <class T>
using PerStrut = Eigen::Matrix<T, kStruts, 1>;
template <class T>
using StrutVectors = Eigen::Matrix<T, 3, kStruts>;
template <class T>
using Matrix6 = Eigen::Matrix<T, 6, 6>;
/// A twist, a small displacement (translation of the tip, rotation vector) or a wrench (force, moment about the tip),
/// in W.
template <class T>
using Vector6 = Eigen::Matrix<T, 6, 1>;

/// Joints as the controller believes them, m. Column j belongs to strut j + 1.
struct Geometry {
  StrutVectors<double> base_joints_W = StrutVectors<double>::Zero();      // q_j
  StrutVectors<double> platform_joints_P = StrutVectors<double>::Zero();  // p_j
  Vector3<double> tool_tip_P = Vector3<double>::Zero();                   // c
};

/// The same machine with a tool of that length (m): it lies along -Z of P and starts at the gauge point.
inline Geometry with_tool(Geometry geometry, double length) {
  geometry.tool_tip_P.z() -= length;
  return geometry;
}

/// Mean distance of the platform joints from their centroid, m: the length that condition numbers are scaled with.
inline double platform_radius(const Geometry& geometry) {
  const Vector3<double> centroid = geometry.platform_joints_P.rowwise().mean();
  return (geometry.platform_joints_P.colwise() - centroid).colwise().norm().mean();
}

}  // namespace plumbline::machine
