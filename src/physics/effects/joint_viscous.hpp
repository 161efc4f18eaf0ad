#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Friction of the joints that grows with the turning of the struts.
struct JointViscous {
  static constexpr std::string_view name = "joint-viscous";
  static constexpr std::array parameters{
      ParameterSpec{.key = "damping_Nms_rad", .unit = machine::units::Nms_rad, .lower = 0, .upper = 1500}};
  static constexpr bool friction = true;

  // -(c / L_j^2) v_perp,j
  template <class T>
  static void transverse_force(Values<T> p, const Situation<T>& at, machine::StrutVectors<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      const T length = at.struts.length[j];
      const Vector3<T> v = at.rates.transverse.col(j);
      sum.col(j) -= p[0] / (length * length) * v;
    }
  }
};

}  // namespace plumbline::physics
