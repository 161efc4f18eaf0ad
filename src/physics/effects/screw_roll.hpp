#pragma once

#include <array>
#include <cmath>

#include "physics/ring.hpp"
#include "physics/situation.hpp"

namespace plumbline::physics {

/// Screws that turn in their nuts because universal joints hold both ends of a strut, as far as the control leaves it.
struct ScrewRoll {
  static constexpr std::string_view name = "screw-roll";
  static constexpr bool rare = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "share", .unit = machine::units::none, .lower = -1, .upper = 1}};
  static constexpr bool path = true;

  static constexpr double kHomeHeight = -1.0;  // m: no roll at the tip (0, 0, -1000) mm in W, A = B = C = 0

  // Angle about u from the inner axis of the base joint, a x u, to that of the platform joint, a' x u. The outer axes
  // a (in W) and a' (in P) lie along the rings on which the joints sit.
  template <class T>
  static T roll(const machine::Geometry& geometry, int j, const Vector3<T>& u, const Matrix3<T>& R_WP) {
    using std::atan2;
    const Vector3<T> base_axis = along_ring(geometry.base_joints_W.col(j)).template cast<T>();
    const Vector3<T> platform_axis = along_ring(geometry.platform_joints_P.col(j)).template cast<T>();
    const Vector3<T> below = base_axis.cross(u);
    const Vector3<T> above = (R_WP * platform_axis).cross(u);
    return atan2(u.dot(below.cross(above)), below.dot(above));
  }

  template <class T>
  static T roll_at_home(const machine::Geometry& geometry, int j) {
    const Vector3<double> tip(0, 0, kHomeHeight);
    const Vector3<double> along =
        tip + geometry.platform_joints_P.col(j) - geometry.tool_tip_P - geometry.base_joints_W.col(j);
    return roll<T>(geometry, j, along.normalized().template cast<T>(), Matrix3<T>::Identity());
  }

  // dL_j = k lead_j / (2 pi) (rho_j - rho_j at home), rho_j the roll: a right-handed screw held by its ends lengthens
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    const machine::Geometry& geometry = at.machine.geometry;
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<T> u = at.struts.direction.col(j);
      const T rolled = roll<T>(geometry, j, u, at.pose.R_WP) - roll_at_home<T>(geometry, j);
      sum[j] += p[0] * T(at.machine.lead_per_radian(j)) * rolled;
    }
  }
};

}  // namespace plumbline::physics
