#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A platform that is heavier or lighter than the model says.
struct PlatformMass {
  static constexpr std::string_view name = "platform-mass";
  static constexpr std::array parameters{
      ParameterSpec{.key = "mass_kg", .unit = machine::units::kg, .lower = -60, .upper = 60}};

  // N += m g, at the centre of mass
  template <class T>
  static void wrench(Values<T> p, const Situation<T>& at, Wrench<T>& sum) {
    sum.add(at.conditions.gravity * p[0], at.arm_to(at.conditions.centre_of_mass_P));
  }
};

}  // namespace plumbline::physics
