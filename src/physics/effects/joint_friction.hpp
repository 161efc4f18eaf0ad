#pragma once

#include <array>

#include "physics/rest_speed.hpp"
#include "physics/situation.hpp"

namespace plumbline::physics {

/// Friction of the base joints: a moment against the turning of the strut, felt by the platform as a force across it.
struct JointFriction {
  static constexpr std::string_view name = "joint-friction";
  static constexpr std::array parameters{model_key("joint", "viscous_friction_Nms_rad", {.label = "joint friction"}),
                                         model_key("joint", "coulomb_friction_Nm")};
  static constexpr bool friction = true;
  enum { kViscous = 0, kCoulomb = 1 };

  // tau_j = -c w_j or -c_c w_j / |w_j| on the strut makes (tau_j x u_j) / L_j on the platform, with w_j = u_j x
  // v_perp,j / L_j:
  // -(c / L_j^2) v_perp,j - (c_c / L_j) v_perp,j / |v_perp,j|  [docs/physics.md; Ibaraki et al., Eq. 9-10 differ in
  // direction]
  template <class T>
  static void transverse_force(Values<T> p, const Situation<T>& at, machine::StrutVectors<T>& sum) {
    if constexpr (kIsPack<T>) {
      if (all(p[kViscous] == T(0.0) && p[kCoulomb] == T(0.0))) return;  // no more than speed: zeros add nothing
    }
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<T> v = at.rates.transverse.col(j);
      const T per_length = T(1.0) / at.struts.length[j];
      const T speed = speed_from_rest(v);
      sum.col(j) -= (p[kViscous] * per_length + p[kCoulomb] / speed) * per_length * v;
    }
  }
};

}  // namespace plumbline::physics
