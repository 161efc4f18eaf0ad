#include "jobs/expected/causes.hpp"

#include <algorithm>

#include "physics/effect_info.hpp"

namespace plumbline::jobs {
namespace {

template <std::size_t N>
bool holds(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 8> kLengths{"gimbal-offset", "lead-error",   "cyclic",         "screw-roll",
                                                   "thermal-drift", "ring-thermal", "spindle-growth", "generic"};
constexpr std::array<std::string_view, 9> kFriction{"screw-coulomb",  "screw-friction", "screw-viscous",
                                                    "screw-stribeck", "load-friction",  "joint-coulomb",
                                                    "joint-friction", "joint-viscous",  "backlash"};

}  // namespace

std::string_view key_of(Cause cause) {
  constexpr std::array<std::string_view, kCauses> kKeys{"geometry", "elasticity",   "friction",
                                                        "noise",    "which_effect", "unexplained"};
  return kKeys[index(cause)];
}

Cause cause_of(std::string_view effect) {
  if (holds(kFriction, effect)) return Cause::friction;
  const std::size_t place = physics::effect_index(effect);
  const bool geometry = place < physics::kEffects && physics::effect_infos()[place].geometry;
  return geometry || holds(kLengths, effect) ? Cause::geometry : Cause::elasticity;
}

}  // namespace plumbline::jobs
