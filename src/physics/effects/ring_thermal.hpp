#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A ring of base joints that is warmer than the rest: it grows away from Z of W.
struct RingThermal {
  static constexpr std::string_view name = "ring-thermal";
  static constexpr bool rare = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "rise_K", .unit = machine::Unit{"K", 1, {}}, .lower = -40, .upper = 40}};
  static constexpr bool path = true;

  static constexpr double kExpansion = 11.5e-6;  // of steel, 1/K

  // dL_j = u_j . alpha dT q_j,xy: u_j the direction from base to platform joint, as for joint-position
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<double> q = at.machine.geometry.base_joints_W.col(j);
      const Vector3<T> u = at.struts.direction.col(j);
      sum[j] += T(kExpansion) * p[0] * (u[0] * T(q[0]) + u[1] * T(q[1]));
    }
  }
};

}  // namespace plumbline::physics
