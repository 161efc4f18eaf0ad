// What descriptions of an unknown effect go by: quantities known at a moment, in handy units. Those of all struts
// alike, and those that each strut has of its own.
#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

// (x - x_0) / 100 mm, x_0 = (0, 0, -1000) mm in W, the X and Y of the platform's Z in W, time / 1 h
inline constexpr int kSharedFactors = 6;
// (L - L_mid) / 100 mm, Ldot / (10 mm/s), s, t / 1 kN, |t| / 1 kN, u_x, u_y, u_z, u in W and t of the nut
inline constexpr int kStrutFactors = 8;
inline constexpr double kMiddleHeight = -1.0;  // m

template <class T>
std::array<T, kSharedFactors> shared_factors(const Situation<T>& at) {
  const Vector3<T>& x = at.pose.p_WT;
  const Vector3<T> z = at.pose.R_WP.col(2);
  return {x[0] * T(10.0), x[1] * T(10.0), (x[2] - T(kMiddleHeight)) * T(10.0),
          z[0],           z[1],           at.motion.time * T(1 / 3600.0)};
}

template <class T>
std::array<T, kStrutFactors> strut_factors(const Situation<T>& at, int j) {
  const Vector3<T> u = at.struts.direction.col(j);
  const T tension = at.nut_tension[j] * T(1e-3);
  return {(at.struts.length[j] - T(at.machine.middle_length[j])) * T(10.0),
          at.rates.speed[j] * T(100.0),
          at.rates.sign[j],
          tension,
          absolute<T>(tension),
          u[0],
          u[1],
          u[2]};
}

// x^n, n = 0 to 4 a whole number
template <class T>
T power(const T& x, const T& n) {
  T result(1.0);
  for (int k = 0; k < 4; ++k) result = select<T>(n > T(k + 0.5), result * x, result);
  return result;
}

/// start x product of the factors to the powers that begin at `first`.
template <class T, std::size_t n>
T times_powers(T start, const std::array<T, n>& factors, Values<T> p, int first) {
  for (std::size_t k = 0; k < n; ++k) start *= power<T>(factors[k], p[first + static_cast<int>(k)]);
  return start;
}

}  // namespace plumbline::physics
