#pragma once

#include <array>
#include <cmath>

#include "physics/bend.hpp"
#include "physics/effects/screw_coulomb.hpp"
#include "physics/situation.hpp"

namespace plumbline::physics {

/// Friction of the screws that fades as they gain speed.
struct ScrewStribeck {
  static constexpr std::string_view name = "screw-stribeck";
  static constexpr std::array parameters{
      ParameterSpec{.key = "force_N", .unit = machine::units::N, .lower = 0, .upper = 300},
      ParameterSpec{
          .key = "speed_mm_s", .unit = machine::units::mm_s, .lower = 1, .upper = 10, .initial = 3, .shape = true}};
  static constexpr bool friction = true;
  enum { kForce = 0, kSpeed = 1 };

  // of one speed it is a Coulomb friction of all struts that fades
  static constexpr std::array kSpeeds{1.0, 1.4, 1.9, 2.6, 3.6, 5.0, 7.2, 10.0};
  static double faded(const StrutMoment& strut, double speed) {
    const double ratio = strut.speed / speed;
    return std::exp(-ratio * ratio);
  }
  static constexpr Bend bend{.by = Bend::By::setting,
                             .size = "force_N",
                             .shape = "speed_mm_s",
                             .tried = kSpeeds,
                             .of = ScrewCoulomb::name,
                             .of_key = "force_N",
                             .factor = faded};

  // f_j = -F s_j exp(-(Ldot_j / v)^2)
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    using std::exp;
    for (int j = 0; j < machine::kStruts; ++j) {
      const T ratio = at.rates.speed[j] / p[kSpeed];
      sum[j] -= p[kForce] * at.rates.sign[j] * exp(-ratio * ratio);
    }
  }
};

}  // namespace plumbline::physics
