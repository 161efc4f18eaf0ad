#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Drives that follow late by different times. Lags that sum to zero tell it from servo-lag.
struct ServoMismatch {
  static constexpr std::string_view name = "servo-mismatch";
  static constexpr bool dynamic = true;
  static constexpr bool sums_to_zero = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "lag_ms", .unit = machine::units::ms, .count = 6, .lower = -5, .upper = 5}};

  // dL_j = -tau_j Ldot_j
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    if (!at.environment.dynamic) return;
    for (int j = 0; j < machine::kStruts; ++j) sum[j] -= p[j] * at.rates.speed[j];
  }
};

}  // namespace plumbline::physics
