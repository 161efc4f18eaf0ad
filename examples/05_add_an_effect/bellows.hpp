#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Bellows that keep chips off a screw: springs along the strut, slack in the middle of its range.
struct Bellows {
  static constexpr std::string_view name = "bellows";
  static constexpr std::array parameters{
      ParameterSpec{.key = "stiffness_N_m", .unit = machine::units::N_m, .count = 6, .lower = 0, .upper = 5000}};

  // f_j = -k_j (L_j - L_mid): a stretched bellows pulls the ends of its strut together, so the screw pulls less
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      sum[j] -= p[j] * (at.struts.length[j] - T(at.machine.middle_length[j]));
    }
  }
};

}  // namespace plumbline::physics
