// The pose of the tool: where its tip is and how the platform is turned.
#pragma once

#include <Eigen/Core>

namespace plumbline {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;

/// Pose of the platform P in the base frame W.
template <class T>
struct Pose {
  Vector3<T> p_WT = Vector3<T>::Zero();      // tool tip in W, m
  Matrix3<T> R_WP = Matrix3<T>::Identity();  // orientation of P in W
};

/// Velocity of the platform at the tool tip.
template <class T>
struct Twist {
  Vector3<T> v_WT = Vector3<T>::Zero();  // of the tip in W, m/s
  Vector3<T> w_WP = Vector3<T>::Zero();  // angular velocity of P in W, rad/s
};

}  // namespace plumbline
