#include "identify/unknowns/named_keys.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::identify;

namespace {

Unknowns none_yet() { return Unknowns(physics::ForceModel(testing::pm600_like())); }

}  // namespace

TEST_CASE("a key of six struts is six unknowns, and a mass of all of them one") {
  Unknowns unknowns = none_yet();
  CHECK(named_unknowns(unknowns, "backlash.width_um") == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
  CHECK(unknowns[5].effect == "backlash");
  CHECK(unknowns[5].index == 5);
  CHECK(unknowns[5].free());
  CHECK(named_unknowns(unknowns, "strut.motor_mass_kg") == std::vector<std::size_t>{6});
  CHECK(unknowns[6].index == -1);
  CHECK(unknowns[6].terms.size() == 6);
}

TEST_CASE("what is unknown already is found again, not added") {
  Unknowns unknowns = none_yet();
  const std::vector<std::size_t> first = named_unknowns(unknowns, "strut.motor_mass_kg");
  CHECK(named_unknowns(unknowns, "strut.motor_mass_kg") == first);
  CHECK(unknowns.size() == 1);
}

TEST_CASE("numbers of which something was known are free once that is asked for") {
  Unknowns unknowns = none_yet();
  const std::size_t mass = named_unknowns(unknowns, "strut.motor_mass_kg").at(0);
  unknowns.set_prior(mass, 2);
  CHECK_FALSE(unknowns[mass].free());
  add_free(unknowns, "strut.motor_mass_kg");
  CHECK(unknowns[mass].free());
}

TEST_CASE("a name that is none is refused with the one that was probably meant") {
  Unknowns unknowns = none_yet();
  const Diagnostic near = testing::refusal_of([&] { named_unknowns(unknowns, "strut.motor_mas_kg"); });
  CHECK(near.code == "identify-unknown-key");
  CHECK(near.help.starts_with("did you mean strut.motor_mass_kg? "));
  CHECK(testing::refusal_of([&] { add_free(unknowns, "motor_mass_kg_of_all_struts"); }).code == "identify-unknown-key");
  CHECK(unknowns.size() == 0);
}

TEST_CASE("a key of [uncertainty] names the keys that it is the sigma of") {
  const std::vector<std::string> joints = names_known_by("joint_position_um");
  CHECK(joints == std::vector<std::string>{"joint-position.base_um", "joint-position.platform_um"});
  CHECK(names_known_by("no_such_key").empty());
}
