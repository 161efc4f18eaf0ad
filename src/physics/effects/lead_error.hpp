#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Screws whose lead is off by a share.
struct LeadError {
  static constexpr std::string_view name = "lead-error";
  static constexpr bool rare = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "error_um_m", .unit = machine::units::um_m, .count = 6, .lower = -500, .upper = 500}};
  static constexpr bool path = true;

  // dL_j = e_j (L_j - L_mid), L_mid the middle of the strut's range
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] += p[j] * (at.struts.length[j] - T(at.machine.middle_length[j]));
  }
};

}  // namespace plumbline::physics
