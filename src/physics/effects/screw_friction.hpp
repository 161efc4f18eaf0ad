#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Coulomb friction of the screws: lengthening pushes, so the tension drops.
struct ScrewFriction {
  static constexpr std::string_view name = "screw-friction";
  static constexpr std::array parameters{
      model_key("strut", "coulomb_friction_N", {.uncertainty = "coulomb_friction_N", .label = "friction"})};
  static constexpr bool friction = true;

  // f_j = -f0_j s_j  [Ibaraki et al., Eq. 8; docs/physics.md]
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] -= p[j] * at.rates.sign[j];
  }
};

}  // namespace plumbline::physics
