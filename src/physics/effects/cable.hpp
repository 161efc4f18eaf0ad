#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Hoses and cables that pull at the platform: a force, and a spring about the middle of the room.
struct Cable {
  static constexpr std::string_view name = "cable";
  static constexpr std::array parameters{
      ParameterSpec{.key = "force_N", .unit = machine::units::N, .count = 3, .lower = -300, .upper = 300},
      ParameterSpec{.key = "stiffness_N_m", .unit = machine::units::N_m, .lower = 0, .upper = 50000}};
  enum { kForce = 0, kStiffness = 3 };

  static constexpr double kRestHeight = -1.0;  // m: x_0 = (0, 0, -1000) mm in W

  // N += F - k (x_tip - x_0), at the centre of mass; x_tip where the machine stands
  template <class T>
  static void wrench(Values<T> p, const Situation<T>& at, Wrench<T>& sum) {
    const Vector3<T> force(p[kForce], p[kForce + 1], p[kForce + 2]);
    const Vector3<T> rest(T(0.0), T(0.0), T(kRestHeight));
    const Vector3<T> pull = force - p[kStiffness] * (at.pose.p_WT - rest);
    sum.add(pull, at.arm_to(at.conditions.centre_of_mass_P));
  }
};

}  // namespace plumbline::physics
