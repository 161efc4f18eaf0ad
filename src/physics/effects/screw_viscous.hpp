#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Friction of the screws that grows with their speed.
struct ScrewViscous {
  static constexpr std::string_view name = "screw-viscous";
  static constexpr std::array parameters{
      ParameterSpec{.key = "damping_N_s_m", .unit = machine::units::N_s_m, .count = 6, .lower = 0, .upper = 8000}};
  static constexpr bool friction = true;

  // f_j = -d_j Ldot_j
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] -= p[j] * at.rates.speed[j];
  }
};

}  // namespace plumbline::physics
