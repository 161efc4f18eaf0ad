#include "jobs/expected/causes.hpp"

#include <set>

#include <catch2/catch.hpp>

#include "physics/effect_info.hpp"

using namespace plumbline;
using jobs::Cause;

TEST_CASE("every effect makes the tip uncertain by one cause") {
  CHECK(jobs::cause_of("joint-position") == Cause::geometry);
  CHECK(jobs::cause_of("strut-offset") == Cause::geometry);
  CHECK(jobs::cause_of("lead-error") == Cause::geometry);
  CHECK(jobs::cause_of("screw-coulomb") == Cause::friction);
  CHECK(jobs::cause_of("backlash") == Cause::friction);
  CHECK(jobs::cause_of("axial-elasticity") == Cause::elasticity);
  CHECK(jobs::cause_of("platform-mass") == Cause::elasticity);
  std::set<Cause> found;
  for (const physics::EffectInfo& info : physics::effect_infos()) found.insert(jobs::cause_of(info.name));
  CHECK(found.size() == 3);
}

TEST_CASE("causes have names of their own") {
  std::set<std::string_view> names;
  for (const Cause cause : jobs::kAllCauses) names.insert(jobs::key_of(cause));
  CHECK(names.size() == jobs::kCauses);
}
