#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// The weight of the platform: m_P g at its centre of mass  [Ibaraki et al., Eq. 4-5].
struct PlatformGravity {
  static constexpr std::string_view name = "platform-gravity";
  static constexpr std::array parameters{
      model_key("platform", "mass_kg", {.uncertainty = "platform_mass_kg", .label = "platform mass"}),
      model_key("platform", "centre_of_mass_mm", {.uncertainty = "centre_of_mass_mm", .label = "centre of mass"})};
  enum { kMass = 0, kCentre = 1 };

  template <class T>
  static void conditions(Values<T> p, const Situation<T>&, Conditions<T>& sum) {
    sum.platform_mass += p[kMass];
    for (int a = 0; a < 3; ++a) sum.centre_of_mass_P[a] += p[kCentre + a];
  }

  // N += m_P g,  M += (R (c_m - c)) x m_P g
  template <class T>
  static void wrench(Values<T>, const Situation<T>& at, Wrench<T>& sum) {
    sum.add(at.conditions.gravity * at.conditions.platform_mass, at.arm_to(at.conditions.centre_of_mass_P));
  }
};

}  // namespace plumbline::physics
