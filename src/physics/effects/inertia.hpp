#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Mass that has to be accelerated.
struct Inertia {
  static constexpr std::string_view name = "inertia";
  static constexpr bool dynamic = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "mass_kg", .unit = machine::units::kg, .lower = 0, .upper = 1000}};

  // N += -m a, at the centre of mass; a the acceleration of the tip
  template <class T>
  static void wrench(Values<T> p, const Situation<T>& at, Wrench<T>& sum) {
    if (!at.environment.dynamic || !at.environment.friction) return;
    sum.add(-p[0] * at.motion.acceleration.v_WT, at.arm_to(at.conditions.centre_of_mass_P));
  }
};

}  // namespace plumbline::physics
