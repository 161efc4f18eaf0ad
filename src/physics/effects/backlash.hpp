#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Play of the screw: a lengthening strut lags behind by half of it.
struct Backlash {
  static constexpr std::string_view name = "backlash";
  static constexpr std::array parameters{
      ParameterSpec{.key = "width_um", .unit = machine::units::um, .count = 6, .lower = 0, .upper = 40}};
  static constexpr bool friction = true;

  // dL_j = -(w_j / 2) s_j
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] -= T(0.5) * p[j] * at.rates.sign[j];
  }
};

}  // namespace plumbline::physics
