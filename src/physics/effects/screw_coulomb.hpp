#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Coulomb friction of the screws beyond the model's.
struct ScrewCoulomb {
  static constexpr std::string_view name = "screw-coulomb";
  static constexpr std::array parameters{
      ParameterSpec{.key = "force_N", .unit = machine::units::N, .count = 6, .lower = 0, .upper = 300}};
  static constexpr bool friction = true;

  // f_j = -F_j s_j
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] -= p[j] * at.rates.sign[j];
  }
};

}  // namespace plumbline::physics
