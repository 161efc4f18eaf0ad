// What makes the tip uncertain.
#pragma once

#include <array>
#include <string_view>

namespace plumbline::jobs {

enum class Cause {
  geometry,      // where joints are and how long struts are, as they are told and with heat
  elasticity,    // what bears on the machine and how it gives way
  friction,      // of screws and joints, and play
  noise,         // of the readings that something was learnt from
  which_effect,  // that was found: those that the readings do not rule out
  unexplained,   // by the model: what it lacks moves each pose otherwise
};
inline constexpr std::size_t kCauses = 6;
inline constexpr std::array<Cause, kCauses> kAllCauses{Cause::geometry, Cause::elasticity,   Cause::friction,
                                                       Cause::noise,    Cause::which_effect, Cause::unexplained};
constexpr std::size_t index(Cause cause) { return static_cast<std::size_t>(cause); }

/// "geometry", "elasticity", "friction", "noise", "which_effect", "unexplained".
std::string_view key_of(Cause cause);

/// What the numbers of an effect belong to: geometry, elasticity or friction.
Cause cause_of(std::string_view effect);

}  // namespace plumbline::jobs
