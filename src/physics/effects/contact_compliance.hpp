#pragma once

#include <array>
#include <cmath>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Balls or rollers of joints and nuts that give way where they touch: the more they are loaded the stiffer they are
/// [Hertz 1881]. Other stiffnesses that change with the load look much like it: found, it is suspected, not named.
struct ContactCompliance {
  static constexpr std::string_view name = "contact-compliance";
  static constexpr bool rare = true;
  static constexpr bool suspect = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "um_at_kN", .unit = machine::units::um, .lower = -60, .upper = 60}};

  static constexpr double kForce = 1000;      // N
  static constexpr double kRoundedOff = 0.1;  // N, below which the slope has a bound

  // dL_j = d sign(t) |t / kN|^(2/3), t_j of the nut
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    using std::sqrt;
    constexpr double kLeast = kRoundedOff / kForce;
    for (int j = 0; j < machine::kStruts; ++j) {
      const T load = at.nut_tension[j] * T(1 / kForce);
      sum[j] += p[0] * load / cube_root(sqrt(load * load + T(kLeast * kLeast)));
    }
  }

 private:
  // 1/3 = 1/4 + 1/16 + 1/64 + ..: four such roots are within 2 % of it for forces of 0.1 N to 10 kN; two steps of
  // Halley make that 1e-16.
  template <class T>
  static T cube_root(const T& x) {
    using std::sqrt;
    T part = sqrt(sqrt(x));
    T root = part;
    for (int k = 0; k < 3; ++k) root *= part = sqrt(sqrt(part));
    for (int k = 0; k < 2; ++k) {
      const T cube = root * root * root;
      root *= (cube + x + x) / (cube + cube + x);
    }
    return root;
  }
};

}  // namespace plumbline::physics
