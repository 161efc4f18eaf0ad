#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A centre of mass that lies elsewhere in P.
struct CentreOfMass {
  static constexpr std::string_view name = "centre-of-mass";
  static constexpr std::array parameters{
      ParameterSpec{.key = "offset_mm", .unit = machine::units::mm, .count = 3, .lower = -60, .upper = 60}};

  // c_m += offset: the moment of m_P g
  template <class T>
  static void conditions(Values<T> p, const Situation<T>&, Conditions<T>& sum) {
    for (int a = 0; a < 3; ++a) sum.centre_of_mass_P[a] += p[a];
  }
};

}  // namespace plumbline::physics
