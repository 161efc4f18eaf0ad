#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Ball screws that are heavier or lighter than the model says.
struct StrutMass {
  static constexpr std::string_view name = "strut-mass";
  static constexpr std::array parameters{
      ParameterSpec{.key = "mass_kg", .unit = machine::units::kg, .lower = -10, .upper = 10}};

  // m_B += m, of each strut
  template <class T>
  static void conditions(Values<T> p, const Situation<T>&, Conditions<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum.screw_mass[j] += p[0];
  }
};

}  // namespace plumbline::physics
