#include "jobs/expected/causes.hpp"

#include <array>

#include "physics/effect_info.hpp"

namespace plumbline::jobs {
std::string_view key_of(Cause cause) {
  constexpr std::array<std::string_view, kCauses> kKeys{"geometry", "elasticity",   "friction",
                                                        "noise",    "which_effect", "unexplained"};
  return kKeys[index(cause)];
}

Cause cause_of(std::string_view effect) {
  const std::size_t place = physics::effect_index(effect);
  if (place >= physics::kEffects) return Cause::elasticity;
  const physics::EffectInfo& info = physics::effect_infos()[place];
  if (info.friction) return Cause::friction;
  return info.geometry || info.path ? Cause::geometry : Cause::elasticity;
}

}  // namespace plumbline::jobs
