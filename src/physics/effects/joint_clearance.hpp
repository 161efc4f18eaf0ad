#pragma once

#include <array>
#include <cmath>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Play of the joints: a strut that pulls stands at one end of it, one that pushes at the other.
struct JointClearance {
  static constexpr std::string_view name = "joint-clearance";
  static constexpr std::array parameters{
      ParameterSpec{.key = "width_um", .unit = machine::units::um, .lower = 0, .upper = 60}};

  static constexpr double kTurnTension = 20;  // N, at which the play is passed through

  // dL_j = (w / 2) tanh(t_j / 20 N), t_j of the nut
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    using std::tanh;
    for (int j = 0; j < machine::kStruts; ++j)
      sum[j] += T(0.5) * p[0] * tanh(at.nut_tension[j] * T(1.0 / kTurnTension));
  }
};

}  // namespace plumbline::physics
