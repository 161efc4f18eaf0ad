#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// The struts as springs: tension lengthens them.
struct AxialElasticity {
  static constexpr std::string_view name = "axial-elasticity";
  static constexpr std::array parameters{
      model_key("strut", "compliance_per_length_um_N_m",
                {.shared = true, .uncertainty = "compliance_relative", .label = "K1"}),
      model_key("strut", "compliance_um_N", {.shared = true, .uncertainty = "compliance_relative", .label = "K2"})};
  enum { kPerLength = 0, kConstant = 6 };

  // K1 L_j + K2, m/N
  template <class T>
  static T compliance(Values<T> p, int strut, const T& length) {
    return p[kPerLength + strut] * length + p[kConstant + strut];
  }

  // dL_j = (K1 L_j + K2) (t_nut,j + f_j)  [Ibaraki et al., Eq. 11; K1 per metre: docs/physics.md]
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      sum[j] += compliance<T>(p, j, at.struts.length[j]) * at.drive_tension[j];
    }
  }
};

}  // namespace plumbline::physics
