#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "physics/factors.hpp"

namespace plumbline::physics {

namespace residual_keys {

constexpr int kFunctions = 35;
constexpr int kDimensions = 3;

constexpr ParameterSpec weights(std::string_view key, machine::Unit unit) {
  return {.key = key, .unit = unit, .count = kFunctions, .lower = -1e6, .upper = 1e6, .optional = true};
}
constexpr ParameterSpec setting(std::string_view key, int count, double upper) {
  return {.key = key,
          .unit = machine::units::none,
          .count = count,
          .upper = upper,
          .optional = true,
          .setting = true,
          .whole = true};
}
constexpr ParameterSpec place(std::string_view key, double lower, double initial) {
  return {.key = key,
          .unit = machine::units::none,
          .count = kDimensions,
          .lower = lower,
          .upper = 1e4,
          .initial = initial,
          .optional = true,
          .setting = true};
}

}  // namespace residual_keys

/// No cause but a description: a smooth function of one to three of the quantities known at a moment, added to one or
/// more channels. What `diagnose` writes where nothing in the catalogue explains what it sees, and no short formula
/// does.
struct Residual {
  static constexpr std::string_view name = "residual";
  static constexpr bool description = true;
  static constexpr bool path = true;
  static constexpr int kFunctions = residual_keys::kFunctions;
  static constexpr int kDimensions = residual_keys::kDimensions;
  static constexpr int kCoordinates = kSharedFactors + kStrutFactors;

  static constexpr std::array parameters{residual_keys::weights("length_um", machine::units::um),
                                         residual_keys::weights("drive_N", machine::units::N),
                                         residual_keys::weights("torque_Nm", machine::units::Nm),
                                         residual_keys::weights("force_N", machine::units::N),
                                         residual_keys::weights("centre_N", machine::units::N),
                                         residual_keys::weights("tip_um", machine::units::um),
                                         residual_keys::setting("part", 1, 6),
                                         residual_keys::setting("strut_powers", kStrutFactors, 4),
                                         residual_keys::setting("shared_powers", kSharedFactors, 4),
                                         residual_keys::setting("coordinates", kDimensions, kCoordinates),
                                         residual_keys::place("middle", -1e4, 0),
                                         residual_keys::place("half_width", 1e-6, 1),
                                         residual_keys::place("lower", -1e4, -1e4),
                                         residual_keys::place("upper", -1e4, 1e4)};
  enum {
    kLength = 0,
    kDrive = kFunctions,
    kTorque = 2 * kFunctions,
    kForce = 3 * kFunctions,
    kCentre = 4 * kFunctions,
    kTip = 5 * kFunctions,
    kPart = 6 * kFunctions,
    kStrutPowers = kPart + 1,
    kSharedPowers = kStrutPowers + kStrutFactors,
    kCoordinate = kSharedPowers + kSharedFactors,
    kMiddle = kCoordinate + kDimensions,
    kHalfWidth = kMiddle + kDimensions,
    kLower = kHalfWidth + kDimensions,
    kUpper = kLower + kDimensions
  };

  // The orders of the functions along their coordinates, those of the lowest sum first; 0: no such coordinate.
  using Orders = std::array<std::array<int, kDimensions>, kFunctions>;
  static constexpr Orders orders(int dimensions) {
    Orders all{};
    std::size_t n = 0;
    for (int sum = dimensions; n < all.size(); ++sum) {
      if (dimensions == 1) all[n++] = {sum, 0, 0};
      for (int a = 1; a < sum && dimensions > 1; ++a) {
        if (dimensions == 2 && n < all.size()) all[n++] = {a, sum - a, 0};
        for (int b = 1; b < sum - a && dimensions == 3 && n < all.size(); ++b) all[n++] = {a, b, sum - a - b};
      }
    }
    return all;
  }

  // How wide the interval is on which the functions stand, what they are used on being one, and the highest order.
  static constexpr double kMargin = 2;
  static constexpr int highest_of(int dimensions) { return dimensions == 1 ? 35 : dimensions == 2 ? 8 : 5; }

  template <class T>
  static T held(const T& x, const T& lower, const T& upper) {
    return select<T>(x < lower, lower, select<T>(x > upper, upper, x));
  }

  // phi_k(x) = sin(pi k (x + c) / 2 c), x = (coordinate - middle) / half width, between -1 and 1
  // [Laplace's eigenfunctions, Solin and Sarkka 2020]
  template <class T>
  static std::array<T, kFunctions> sines(const T& coordinate, const T& middle, const T& half_width, int highest) {
    using std::cos;
    using std::sin;
    const T x = held<T>((coordinate - middle) / half_width, T(-1.0), T(1.0));
    const T angle = (x + T(kMargin)) * T(std::numbers::pi / (2 * kMargin));
    const T twice = T(2.0) * cos(angle);
    std::array<T, kFunctions> all;
    all.fill(T(0.0));
    all[0] = sin(angle);
    all[1] = twice * all[0];
    for (std::size_t k = 2; k < static_cast<std::size_t>(highest); ++k) all[k] = twice * all[k - 1] - all[k - 2];
    return all;
  }

  // sum_k w_k phi_k of the coordinates, each held between lower and upper: outside of the region measured it stays as
  // it is at the border; nil where there is none, or one that `factors` has not
  template <class T>
  static T of_factors(Values<T> p, int weights, const std::array<T, kCoordinates>& factors, int known) {
    int dimensions = 0;
    for (; dimensions < kDimensions && p.whole(kCoordinate + dimensions) > 0; ++dimensions) {
      if (p.whole(kCoordinate + dimensions) > known) return T(0.0);
    }
    if (dimensions == 0) return T(0.0);
    static constexpr std::array kOrders{orders(1), orders(2), orders(3)};
    const Orders& order = kOrders[static_cast<std::size_t>(dimensions - 1)];
    std::array<std::array<T, kFunctions>, kDimensions> along;
    for (int d = 0; d < dimensions; ++d) {
      const auto coordinate = static_cast<std::size_t>(p.whole(kCoordinate + d) - 1);
      const T within = held<T>(factors[coordinate], p[kLower + d], p[kUpper + d]);
      along[static_cast<std::size_t>(d)] = sines<T>(within, p[kMiddle + d], p[kHalfWidth + d], highest_of(dimensions));
    }
    T sum(0.0);
    for (std::size_t k = 0; k < kFunctions; ++k) {
      T product = p[weights + static_cast<int>(k)];
      for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
        product *= along[d][static_cast<std::size_t>(order[k][d] - 1)];
      }
      sum += product;
    }
    return sum;
  }

  template <class T>
  static std::array<T, kCoordinates> shared_alone(const Situation<T>& at) {
    std::array<T, kCoordinates> factors;
    factors.fill(T(0.0));
    const auto shared = shared_factors<T>(at);
    for (std::size_t k = 0; k < kSharedFactors; ++k) factors[k] = shared[k];
    return factors;
  }

  template <class T>
  static void add(Values<T> p, int weights, const Situation<T>& at, machine::PerStrut<T>& sum) {
    if (p.idle(weights, kFunctions)) return;
    const int part = p.whole(kPart);
    std::array<T, kCoordinates> factors = shared_alone<T>(at);
    const T shared = times_powers<T>(T(1.0), shared_factors<T>(at), p, kSharedPowers);
    for (int j = 0; j < machine::kStruts; ++j) {
      if (part != 0 && part != j + 1) continue;
      const auto own = strut_factors<T>(at, j);
      for (std::size_t k = 0; k < kStrutFactors; ++k) factors[kSharedFactors + k] = own[k];
      sum[j] += of_factors<T>(p, weights, factors, kCoordinates) * times_powers<T>(shared, own, p, kStrutPowers);
    }
  }

  // along the axis that is the part; along all three where there is none
  template <class T>
  static Vector3<T> vector(Values<T> p, int weights, const Situation<T>& at) {
    Vector3<T> sum = Vector3<T>::Zero();
    if (p.idle(weights, kFunctions)) return sum;
    const T size = of_factors<T>(p, weights, shared_alone<T>(at), kSharedFactors) *
                   times_powers<T>(T(1.0), shared_factors<T>(at), p, kSharedPowers);
    const int part = p.whole(kPart);
    for (int a = 0; a < 3; ++a) {
      if (part == 0 || part == a + 1) sum[a] = size;
    }
    return sum;
  }

  // N += F(coordinates) x shared powers, at the tool tip and at the platform's centre of mass
  template <class T>
  static void wrench(Values<T> p, const Situation<T>& at, Wrench<T>& sum) {
    sum.add(vector<T>(p, kForce, at), Vector3<T>::Zero());
    sum.add(vector<T>(p, kCentre, at), at.arm_to(at.conditions.centre_of_mass_P));
  }

  // f_j += g(coordinates) x powers
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    add<T>(p, kDrive, at, sum);
  }

  // dL_j += g(coordinates) x powers
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    add<T>(p, kLength, at, sum);
  }

  // dx += g(coordinates) x shared powers
  template <class T>
  static void tip(Values<T> p, const Situation<T>& at, machine::Vector6<T>& sum) {
    sum.template head<3>() += vector<T>(p, kTip, at);
  }

  // torque_j += g(coordinates) x powers
  template <class T>
  static void reading(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    add<T>(p, kTorque, at, sum);
  }
};

}  // namespace plumbline::physics
