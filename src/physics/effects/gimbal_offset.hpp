#pragma once

#include <array>
#include <cmath>

#include "physics/ring.hpp"
#include "physics/situation.hpp"

namespace plumbline::physics {

/// Axes of a base joint that do not meet: the inner one, across the strut, goes round the outer one at a distance.
struct GimbalOffset {
  static constexpr std::string_view name = "gimbal-offset";
  static constexpr bool rare = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "offset_um", .unit = machine::units::um, .count = 6, .lower = -5000, .upper = 5000}};
  static constexpr bool path = true;

  // dL_j = e_j sqrt(1 - (a_j . u_j)^2): the strut begins at q_j + e_j n_j, n_j the part of u_j across a_j, normalised.
  // a_j is the outer axis, along the ring of base joints: along_ring(q_j).
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    using std::sqrt;
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<double> axis = along_ring(at.machine.geometry.base_joints_W.col(j));
      const Vector3<T> u = at.struts.direction.col(j);
      const T along = u.dot(axis.template cast<T>());
      sum[j] += p[j] * sqrt(T(1.0) - along * along);
    }
  }
};

}  // namespace plumbline::physics
