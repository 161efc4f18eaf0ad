#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Friction of the screws in proportion to their load.
struct LoadFriction {
  static constexpr std::string_view name = "load-friction";
  static constexpr std::array parameters{
      ParameterSpec{.key = "mu", .unit = machine::units::none, .lower = 0, .upper = 0.2}};
  static constexpr bool friction = true;

  // f_j = -mu |t_nut,j| s_j
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] -= p[0] * absolute<T>(at.nut_tension[j]) * at.rates.sign[j];
  }
};

}  // namespace plumbline::physics
