#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Torque readings that are off by a share.
struct TorqueScale {
  static constexpr std::string_view name = "torque-scale";
  static constexpr std::array parameters{
      ParameterSpec{.key = "percent", .unit = machine::units::percent, .count = 6, .lower = -30, .upper = 30}};

  // torque_j (1 + k_j)
  template <class T>
  static void reading(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] += p[j] * at.torque[j];
  }
};

}  // namespace plumbline::physics
