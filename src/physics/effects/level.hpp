#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A machine that stands askew: gravity is turned by (rx, ry).
struct Level {
  static constexpr std::string_view name = "level";
  static constexpr std::array parameters{ParameterSpec{.key = "tilt_mrad",
                                                       .unit = machine::units::mrad,
                                                       .count = 2,
                                                       .lower = -10,
                                                       .upper = 10,
                                                       .uncertainty = "level_mrad"}};

  // g += |g| (-ry, rx, 0), |g| of the model: the gravity vector (0, 0, -|g|) turned by +r
  template <class T>
  static void conditions(Values<T> p, const Situation<T>& at, Conditions<T>& sum) {
    const T g(at.machine.gravity.norm());
    sum.gravity[0] -= g * p[1];
    sum.gravity[1] += g * p[0];
  }
};

}  // namespace plumbline::physics
