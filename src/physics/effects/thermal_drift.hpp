#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Screws of steel that warm up or cool down at a constant rate.
struct ThermalDrift {
  static constexpr std::string_view name = "thermal-drift";
  static constexpr std::array parameters{
      ParameterSpec{.key = "rate_K_h", .unit = machine::units::K_h, .count = 6, .lower = -8, .upper = 8}};
  static constexpr bool path = true;

  static constexpr double kExpansion = 11.5e-6;  // of steel, 1/K

  // dL_j = 11.5e-6/K L_j rate_j time
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] += T(kExpansion) * at.struts.length[j] * p[j] * at.motion.time;
  }
};

}  // namespace plumbline::physics
