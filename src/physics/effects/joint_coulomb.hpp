#pragma once

#include <array>

#include "physics/rest_speed.hpp"
#include "physics/situation.hpp"

namespace plumbline::physics {

/// Dry friction of the joints against the turning of the struts.
struct JointCoulomb {
  static constexpr std::string_view name = "joint-coulomb";
  static constexpr std::array parameters{
      ParameterSpec{.key = "moment_Nm", .unit = machine::units::Nm, .lower = 0, .upper = 40}};
  static constexpr bool friction = true;

  // -(M / L_j) v_perp,j / |v_perp,j|
  template <class T>
  static void transverse_force(Values<T> p, const Situation<T>& at, machine::StrutVectors<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<T> v = at.rates.transverse.col(j);
      const T speed = speed_from_rest(v);
      sum.col(j) -= p[0] / (at.struts.length[j] * speed) * v;
    }
  }
};

}  // namespace plumbline::physics
