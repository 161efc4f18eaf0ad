#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A control whose drives all follow late by the same time.
struct ServoLag {
  static constexpr std::string_view name = "servo-lag";
  static constexpr bool dynamic = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "lag_ms", .unit = machine::units::ms, .lower = 0, .upper = 60}};

  // dL_j = -tau Ldot_j + tau^2 Lddot_j
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    if (!at.environment.dynamic) return;
    for (int j = 0; j < machine::kStruts; ++j) sum[j] += p[0] * (p[0] * at.rates.acceleration[j] - at.rates.speed[j]);
  }
};

}  // namespace plumbline::physics
