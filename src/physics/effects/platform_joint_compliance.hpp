#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Platform joints that give way, along the axis of the platform and across it not alike.
struct PlatformJointCompliance {
  static constexpr std::string_view name = "platform-joint-compliance";
  static constexpr std::array parameters{
      ParameterSpec{.key = "radial_um_N", .unit = machine::units::um_N, .lower = 0, .upper = 0.05},
      ParameterSpec{.key = "axial_um_N", .unit = machine::units::um_N, .lower = 0, .upper = 0.05}};
  enum { kRadial = 0, kAxial = 1 };

  // dL_j = t_j (c_r (u_x^2 + u_y^2) + c_a u_z^2), u in P, t_j of the nut
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<T> u = at.pose.R_WP.transpose() * at.struts.direction.col(j);
      sum[j] += at.nut_tension[j] * (p[kRadial] * (u[0] * u[0] + u[1] * u[1]) + p[kAxial] * u[2] * u[2]);
    }
  }
};

}  // namespace plumbline::physics
