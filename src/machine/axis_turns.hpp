// A, B, C as sines and cosines: orientations, their rates and what lies between them without further trigonometry, for
// packs. machine/orientation.hpp has the same for angles.
#pragma once

#include "base/scalar.hpp"
#include "machine/orientation.hpp"

namespace plumbline::machine {

/// Sines and cosines in the order of the product, leftmost first. Where the axes run against the order X, Y, Z, all
/// rotations turn the other way about mirrored axes: the sines change their signs, and every order is that of X, Y, Z.
template <class T>
struct AxisTurns {
  Vector3<T> sine;
  Vector3<T> cosine;
};

/// abc: rad, about X, Y, Z.
template <class T>
AxisTurns<T> axis_turns(const RotationOrder& order, const Vector3<T>& abc) {
  AxisTurns<T> turns;
  for (int n = 0; n < 3; ++n) {
    const SineCosine<T> of = sine_cosine(abc[order.axes[static_cast<std::size_t>(n)]]);
    turns.sine[n] = order.parity() > 0 ? of.sine : -of.sine;
    turns.cosine[n] = of.cosine;
  }
  return turns;
}

/// R_WP = R_i R_j R_k, as rotation() has it.
template <class T>
Matrix3<T> rotation(const RotationOrder& order, const AxisTurns<T>& turns) {
  const T& sa = turns.sine[0];
  const T& sb = turns.sine[1];
  const T& sc = turns.sine[2];
  const T& ca = turns.cosine[0];
  const T& cb = turns.cosine[1];
  const T& cc = turns.cosine[2];
  const auto [i, j, k] = order.axes;
  Matrix3<T> R;
  R(i, i) = cb * cc;
  R(i, j) = -(cb * sc);
  R(i, k) = sb;
  R(j, i) = ca * sc + sa * sb * cc;
  R(j, j) = ca * cc - sa * sb * sc;
  R(j, k) = -(sa * cb);
  R(k, i) = sa * sc - ca * sb * cc;
  R(k, j) = sa * cc + ca * sb * sc;
  R(k, k) = ca * cb;
  return R;
}

/// Angular velocity of P in W and its derivative, for angles that go at constant rates `abc_rate`.
template <class T>
struct Turning {
  Vector3<T> velocity, acceleration;
};
template <class T>
Turning<T> turning(const RotationOrder& order, const AxisTurns<T>& turns, const Vector3<T>& abc_rate) {
  const T& sa = turns.sine[0];
  const T& sb = turns.sine[1];
  const T& ca = turns.cosine[0];
  const T& cb = turns.cosine[1];
  const auto [i, j, k] = order.axes;
  // mirrored axes mirror the sense of both the rates and the velocity that they make
  const T parity(order.parity());
  const T a = parity * abc_rate[i];
  const T b = parity * abc_rate[j];
  const T c = parity * abc_rate[k];
  Turning<T> turning;
  turning.velocity[i] = parity * (a + sb * c);
  turning.velocity[j] = parity * (ca * b - sa * cb * c);
  turning.velocity[k] = parity * (sa * b + ca * cb * c);
  turning.acceleration[i] = parity * (cb * b * c);
  turning.acceleration[j] = parity * (sa * sb * b * c - sa * a * b - ca * cb * a * c);
  turning.acceleration[k] = parity * (ca * a * b - sa * cb * a * c - ca * sb * b * c);
  return turning;
}

/// By how much A, B, C of an orientation differ from those that `turns` are of, rad.
template <class T>
struct AngleChange {
  Vector3<T> abc;
  MaskOf<T> sure;  // less than 0.05 rad each, and the middle angle further from a right angle than 0.01 rad
};
template <class T>
AngleChange<T> angle_change(const RotationOrder& order, const AxisTurns<T>& from, const Matrix3<T>& R_WP) {
  using std::sqrt;
  const auto [i, j, k] = order.axes;
  // R = [cb cc, -cb sc, sb; .., .., -sa cb; .., .., ca cb] along i, j, k; cb keeps its sign
  const T side = select<T>(from.cosine[1] < T(0.0), T(-1.0), T(1.0));
  const T outer = sqrt(R_WP(j, k) * R_WP(j, k) + R_WP(k, k) * R_WP(k, k));
  const Vector3<T> sine(-(side * R_WP(j, k)), R_WP(i, k), -(side * R_WP(i, j)));
  const Vector3<T> cosine(side * R_WP(k, k), side * outer, side * R_WP(i, i));
  AngleChange<T> change{{}, absolute<T>(from.cosine[1]) > T(0.01)};
  const std::array<int, 3> axes = order.axes;
  for (int n = 0; n < 3; ++n) {
    const T along = cosine[n] * from.cosine[n] + sine[n] * from.sine[n];
    const T tangent = (sine[n] * from.cosine[n] - cosine[n] * from.sine[n]) / along;
    change.sure = change.sure && along > T(0.0) && absolute<T>(tangent) < T(0.05);
    change.abc[axes[static_cast<std::size_t>(n)]] = T(order.parity()) * small_arc_tangent(tangent);
  }
  return change;
}

}  // namespace plumbline::machine
