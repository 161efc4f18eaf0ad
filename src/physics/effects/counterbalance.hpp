#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A constant force on the platform, as a spring or a cylinder that carries its weight makes.
struct Counterbalance {
  static constexpr std::string_view name = "counterbalance";
  static constexpr bool rare = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "force_N", .unit = machine::units::N, .count = 3, .lower = -3000, .upper = 3000}};

  // N += F, constant in W, at the centre of mass
  template <class T>
  static void wrench(Values<T> p, const Situation<T>& at, Wrench<T>& sum) {
    sum.add(Vector3<T>(p[0], p[1], p[2]), at.arm_to(at.conditions.centre_of_mass_P));
  }
};

}  // namespace plumbline::physics
