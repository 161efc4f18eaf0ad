#pragma once

#include <array>
#include <cmath>

#include "physics/bend.hpp"
#include "physics/effects/strut_offset.hpp"
#include "physics/situation.hpp"

namespace plumbline::physics {

/// An error of the screws that comes back with each turn.
struct Cyclic {
  static constexpr std::string_view name = "cyclic";
  static constexpr std::array parameters{
      ParameterSpec{.key = "amplitude_um", .unit = machine::units::um, .count = 6, .lower = -50, .upper = 50},
      ParameterSpec{.key = "phase_deg",
                    .unit = machine::units::deg,
                    .count = 6,
                    .lower = -180,
                    .upper = 180,
                    .shape = true,
                    .periodic = true}};
  static constexpr bool path = true;
  enum { kAmplitude = 0, kPhase = 6 };

  static double sine(const StrutMoment& strut, double phase) { return std::sin(strut.turn + phase); }
  static double cosine(const StrutMoment& strut) { return std::cos(strut.turn); }
  static constexpr Bend bend{.by = Bend::By::phase,
                             .size = "amplitude_um",
                             .shape = "phase_deg",
                             .of = StrutOffset::name,
                             .of_key = "length_um",
                             .factor = sine,
                             .quarter_turn_on = cosine};

  // dL_j = a_j sin(2 pi L_j / lead + phase_j)
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    using std::sin;
    for (int j = 0; j < machine::kStruts; ++j) {
      const T turns = at.struts.length[j] * T(at.machine.radians_per_length(j));
      sum[j] += p[kAmplitude + j] * sin(turns + p[kPhase + j]);
    }
  }
};

}  // namespace plumbline::physics
