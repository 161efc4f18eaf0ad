#pragma once

#include <array>

#include "physics/bend.hpp"
#include "physics/effects/strut_offset.hpp"
#include "physics/situation.hpp"

namespace plumbline::physics {

/// A control whose drives all follow late by the same time.
struct ServoLag {
  static constexpr std::string_view name = "servo-lag";
  static constexpr bool dynamic = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "lag_ms", .unit = machine::units::ms, .lower = 0, .upper = 60}};

  // per unit of a lag of tau all struts are longer by this. Small lags move the tip along its circle, where the bar
  // does not see them.
  static constexpr std::array kLags{10.0, 20.0, 35.0, 55.0};
  static double behind(const StrutMoment& strut, double lag) { return lag * strut.acceleration - strut.speed; }
  static constexpr Bend bend{.by = Bend::By::size,
                             .size = "lag_ms",
                             .shape = "lag_ms",
                             .tried = kLags,
                             .of = StrutOffset::name,
                             .of_key = "length_um",
                             .factor = behind};

  // dL_j = -tau Ldot_j + tau^2 Lddot_j; beside L_j(t - tau) = L_j - tau Ldot_j + tau^2 / 2 Lddot_j, which is on the
  // path, only later, it is tau^2 / 2 Lddot_j
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    if (!at.environment.dynamic) return;
    for (int j = 0; j < machine::kStruts; ++j) {
      const T bent = p[0] * at.rates.acceleration[j];
      sum[j] += p[0] * (at.environment.late ? T(bent - at.rates.speed[j]) : T(0.5 * bent));
    }
  }
};

}  // namespace plumbline::physics
