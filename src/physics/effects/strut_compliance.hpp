#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Struts that give way more than the model says.
struct StrutCompliance {
  static constexpr std::string_view name = "strut-compliance";
  static constexpr std::array parameters{
      ParameterSpec{.key = "compliance_um_N", .unit = machine::units::um_N, .count = 6, .lower = 0, .upper = 0.05}};

  // dL_j = k_j (t_nut,j + f_j)
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] += p[j] * at.drive_tension[j];
  }
};

}  // namespace plumbline::physics
