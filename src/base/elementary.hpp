// Sine, cosine, exponential, hyperbolic tangent and arc tangents of lanes. Made of what IEEE 754 rounds correctly and
// of nothing else, so that every processor gives the same bits. Polynomials interpolate at Chebyshev nodes, worked out
// with 50 digits.
#pragma once

#include "base/lanes.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.hpp

namespace plumbline {

inline constexpr double kRounds = 6755399441055744.0;  // 1.5 x 2^52: adding it rounds to a whole number
inline constexpr double kReducedAngle = 1e6;           // rad, to which sines and cosines are sure

/// a[0] + a[1] x + a[2] x^2 + ...
template <class T, std::size_t n>
PLUMBLINE_INLINE T polynomial(const T& x, const double (&a)[n]) {
  T sum(a[n - 1]);
  for (std::size_t k = n - 1; k-- > 0;) sum = sum * x + T(a[k]);
  return sum;
}

template <class T>
struct SineCosine {
  T sine, cosine;
};

/// Both within 2.2e-16 for |x| <= 1e6 rad; NaN beyond.
template <class T>
PLUMBLINE_INLINE SineCosine<T> sine_cosine(const T& x) {
  // x = n pi/2 + r, |r| <= pi/4, pi/2 in three parts of which n times the first two is exact  [Cody and Waite 1980]
  const T whole = x * T(0.63661977236758134308) + T(kRounds);
  const T n = whole - T(kRounds);
  T r = x - n * T(1.5707963267341256);
  r = r - n * T(6.077100506303966e-11);
  r = r - n * T(2.0222662487959506e-21);
  const T z = r * r;
  const T s = r + r * z *
                      polynomial(z, {-0.16666666666666666, 0.008333333333330948, -0.00019841269836758574,
                                     2.7557316102551507e-06, -2.5051131844808866e-08, 1.5918129280835e-10});
  const T c = T(1.0) - T(0.5) * z +
              z * z *
                  polynomial(z, {0.041666666666666664, -0.0013888888888887398, 2.4801587298765686e-05,
                                 -2.755731727172921e-07, 2.087614626828136e-09, -1.1382632416743667e-11});
  const auto quarter = whole.bits();
  const auto odd = T::Mask::of(-(quarter & 1));
  const T sine_size = T::choose(odd, c, s);
  const T cosine_size = T::choose(odd, s, c);
  const T sine = T::from_bits(sine_size.bits() ^ ((quarter & 2) << 62));
  const T cosine = T::from_bits(cosine_size.bits() ^ (((quarter + 1) & 2) << 62));
  const auto sure = abs(x) <= T(kReducedAngle);
  const T none(__builtin_nan(""));
  return {T::choose(sure, sine, none), T::choose(sure, cosine, none)};
}

template <class Processor, int N>
PLUMBLINE_INLINE Lanes<Processor, N> sin(const Lanes<Processor, N>& x) {
  return sine_cosine(x).sine;
}
template <class Processor, int N>
PLUMBLINE_INLINE Lanes<Processor, N> cos(const Lanes<Processor, N>& x) {
  return sine_cosine(x).cosine;
}

/// Within 2.5e-16 of e^x, relative; 0 below -700, where e^x is 1e-304, and infinite above 709.
template <class Processor, int N>
PLUMBLINE_INLINE Lanes<Processor, N> exp(const Lanes<Processor, N>& x) {
  using T = Lanes<Processor, N>;
  // x = n ln 2 + r, |r| <= ln 2 / 2, ln 2 in two parts of which n times the first is exact
  const T whole = x * T(1.4426950408889634) + T(kRounds);
  const T n = whole - T(kRounds);
  const T r = (x - n * T(0.6931471803691238)) - n * T(1.9082149292705877e-10);
  const T p = T(1.0) + (r + r * r *
                                polynomial(r, {0.5, 0.1666666666666667, 0.04166666666666667, 0.008333333333326141,
                                               0.0013888888888883752, 0.00019841269874800512, 2.4801587325533377e-05,
                                               2.7557255425720897e-06, 2.75572736613304e-07, 2.510520638458724e-08,
                                               2.091467938417506e-09}));
  // n stands in the low bits of `whole`: 2^n by its exponent, in two halves since 2^1023 p may still be finite
  const T power = T::from_bits((whole.bits() + 1022) << 52);
  const T scaled = p * power * T(2.0);
  return T::choose(x < T(-700.0), T(0.0), T::choose(x > T(709.0), T(__builtin_inf()), scaled));
}

/// Within 3e-16, absolute. Exactly 1 or -1 where |x| >= 20.
template <class Processor, int N>
PLUMBLINE_INLINE Lanes<Processor, N> tanh(const Lanes<Processor, N>& x) {
  using T = Lanes<Processor, N>;
  const auto saturated = abs(x) >= T(20.0);
  const T sign = copysign(T(1.0), x);
  if (saturated.all()) return sign;
  const T e = exp(T::choose(saturated, T(0.0), x + x));
  return T::choose(saturated, sign, (e - T(1.0)) / (e + T(1.0)));
}

/// Within 1e-17 |t|, besides rounding, for |t| <= 0.05: the series to t^11.
template <class T>
PLUMBLINE_INLINE T small_arc_tangent(const T& t) {
  const T z = t * t;
  return t + t * z * polynomial(z, {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11});
}

/// The angle of the direction (x, y), within 5e-16 rad; 0 of (0, 0). Neither may be infinite.
template <class Processor, int N>
PLUMBLINE_INLINE Lanes<Processor, N> atan2(const Lanes<Processor, N>& y, const Lanes<Processor, N>& x) {
  using T = Lanes<Processor, N>;
  const auto steep = abs(y) > abs(x);
  const T larger = T::choose(steep, abs(y), abs(x));
  const T smaller = T::choose(steep, abs(x), abs(y));
  // atan t = pi/4 + atan((t - 1) / (t + 1)): |u| <= tan(pi/8)
  const auto beyond = smaller > larger * T(0.41421356237309503);
  const T below = T::choose(beyond, larger + smaller, larger);
  const T above = T::choose(beyond, smaller - larger, smaller);
  const T u = above / T::choose(below == T(0.0), T(1.0), below);
  const T z = u * u;
  T angle = u + u * z *
                    polynomial(z, {-0.3333333333333333, 0.1999999999999552, -0.14285714284666456, 0.1111111101524943,
                                   -0.09090904577842225, 0.07692183184282383, -0.0666451135520762, 0.05858148112085185,
                                   -0.050854455478168435, 0.03923153724516447, -0.019176738872388188});
  constexpr double kQuarterTurn = 1.5707963267948966;
  angle = T::choose(beyond, T(kQuarterTurn / 2) + angle, angle);
  angle = T::choose(steep, T(kQuarterTurn) - angle, angle);
  angle = T::choose(x < T(0.0), T(2 * kQuarterTurn) - angle, angle);
  return copysign(angle, y);
}

}  // namespace plumbline

#pragma GCC diagnostic pop
