// Orientations: rotation matrices from the control's A, B, C and back, and rotation vectors.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "base/pose.hpp"
#include "base/scalar.hpp"

namespace plumbline::machine {

/// The order in which A (about X), B (about Y) and C (about Z) compose: "ZYX" is R = Rz(C) Ry(B) Rx(A).
struct RotationOrder {
  std::array<int, 3> axes{2, 1, 0};  // of the product from left to right; 0 = X, 1 = Y, 2 = Z

  bool operator==(const RotationOrder&) const = default;
  /// +1 if the axes follow each other as X, Y, Z do, else -1.
  int parity() const { return (axes[1] - axes[0] + 3) % 3 == 1 ? 1 : -1; }
};

/// The order that a text of three different letters of X, Y, Z names; nothing for any other text.
std::optional<RotationOrder> rotation_order(std::string_view text);
std::string to_text(const RotationOrder& order);

/// Rotation by `angle` (rad) about the X, Y or Z axis (0, 1, 2).
template <class T>
Matrix3<T> axis_rotation(int axis, const T& angle) {
  using std::cos;
  using std::sin;
  const int j = (axis + 1) % 3;
  const int k = (axis + 2) % 3;
  const T c = cos(angle);
  const T s = sin(angle);
  Matrix3<T> R = Matrix3<T>::Identity();
  R(j, j) = c;
  R(j, k) = -s;
  R(k, j) = s;
  R(k, k) = c;
  return R;
}

/// R_WP of A, B, C (rad) in that order.
template <class T>
Matrix3<T> rotation(const RotationOrder& order, const Vector3<T>& abc) {
  const auto [i, j, k] = order.axes;
  return axis_rotation<T>(i, abc[i]) * axis_rotation<T>(j, abc[j]) * axis_rotation<T>(k, abc[k]);
}

/// Angular velocity of P in W (rad/s) at A, B, C (rad) that turn with the rates `abc_rate` (rad/s).
template <class T>
Vector3<T> angular_velocity(const RotationOrder& order, const Vector3<T>& abc, const Vector3<T>& abc_rate) {
  // w = e_i i' + R_i (e_j j' + R_j e_k k'): each rate about its axis as the rotations left of it have turned it
  const auto [i, j, k] = order.axes;
  const Vector3<T> last = axis_rotation<T>(j, abc[j]).col(k) * abc_rate[k];
  const Vector3<T> inner = Vector3<T>::Unit(j) * abc_rate[j] + last;
  return Vector3<T>::Unit(i) * abc_rate[i] + axis_rotation<T>(i, abc[i]) * inner;
}

/// A, B, C of an orientation.
struct Angles {
  Vector3<double> abc = Vector3<double>::Zero();  // rad
  bool gimbal_lock = false;  // the outer axes coincide: only their sum is determined, the first was kept as it was
};

/// The A, B, C (rad) of R_WP that lie nearest to `reference`: of both solutions and all multiples of a turn. Where the
/// middle angle is within 1e-7 rad of a right angle, the leftmost angle of the order keeps its reference value and the
/// others follow; R_WP is met all the same (to 1e-7 rad).
Angles nearest_angles(const RotationOrder& order, const Matrix3<double>& R_WP, const Vector3<double>& reference);

/// The matrix [w]x: skew(w) a = w x a.
template <class T>
Matrix3<T> skew(const Vector3<T>& w) {
  Matrix3<T> S;
  S << T(0.0), -w[2], w[1], w[2], T(0.0), -w[0], -w[1], w[0], T(0.0);
  return S;
}

/// The rotation by |w| rad about w. Well-behaved at zero, its derivatives too.
template <class T>
Matrix3<T> exponential(const Vector3<T>& w) {
  // exp([w]) = I + a [w] + b [w]^2, a = sin t / t, b = (1 - cos t) / t^2, t = |w|  [Rodrigues]
  using std::cos;
  using std::sin;
  using std::sqrt;
  const T t2 = w.squaredNorm();
  const auto small = t2 < T(1e-4);  // the series' next terms are below 1e-17 there
  const T safe = select<T>(small, T(1.0), t2);
  const T t = sqrt(safe);
  const T a = select<T>(small, T(1.0) - t2 / T(6.0) * (T(1.0) - t2 / T(20.0) * (T(1.0) - t2 / T(42.0))), sin(t) / t);
  const T half = sin(t * T(0.5));
  const T b = select<T>(small, T(0.5) - t2 / T(24.0) * (T(1.0) - t2 / T(30.0) * (T(1.0) - t2 / T(56.0))),
                        T(2.0) * half * half / safe);
  const Matrix3<T> S = skew<T>(w);
  return Matrix3<T>::Identity() + a * S + b * (S * S);
}

/// The same for rotations far below a radian (corrections, steps of an iteration), without trigonometry: the error is
/// |w|^7 / 5040 rad.
template <class T>
Matrix3<T> small_rotation(const Vector3<T>& w) {
  const T t2 = w.squaredNorm();
  const T a = T(1.0) - t2 * (T(1.0 / 6.0) - t2 * T(1.0 / 120.0));
  const T b = T(0.5) - t2 * (T(1.0 / 24.0) - t2 * T(1.0 / 720.0));
  const Matrix3<T> S = skew<T>(w);
  return Matrix3<T>::Identity() + a * S + b * (S * S);
}

/// The rotation vector w with exponential(w) = R. For rotations below half a turn: the accuracy falls off as
/// 1e-16 / (pi - |w|), and at half a turn the result is meaningless.
template <class T>
Vector3<T> logarithm(const Matrix3<T>& R) {
  using std::atan2;
  using std::sqrt;
  // vee(R - R^T) / 2 = sin t n, (tr R - 1) / 2 = cos t
  const Vector3<T> s(T(0.5) * (R(2, 1) - R(1, 2)), T(0.5) * (R(0, 2) - R(2, 0)), T(0.5) * (R(1, 0) - R(0, 1)));
  const T c = T(0.5) * (R(0, 0) + R(1, 1) + R(2, 2) - T(1.0));
  const T s2 = s.squaredNorm();
  const auto small = s2 < T(1e-6) && c > T(0.0);
  const T safe = sqrt(select<T>(small, T(1.0), s2));
  // asin(x) / x = 1 + x^2/6 + 3 x^4/40 + ...
  const T series = T(1.0) + s2 * (T(1.0 / 6.0) + s2 * T(3.0 / 40.0));
  return s * select<T>(small, series, atan2(safe, c) / safe);
}

}  // namespace plumbline::machine
