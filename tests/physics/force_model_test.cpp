#include "physics/force_model.hpp"

#include <catch2/catch.hpp>

#include "base/check.hpp"
#include "machine/bad_files.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

ForceModel with_rows(const std::string& rows) {
  return ForceModel(machine::parse_model(pm600_like().document.text + "\n" + rows, "m.toml"));
}

}  // namespace

TEST_CASE("base parameters come from the model's tables, effects from its rows, all in SI") {
  const ForceModel model = with_rows(
      "[[effect]]\nname = \"backlash\"\nwidth_um = [4, 0, 0, 0, 0, 1]\n"
      "[[effect]]\nname = \"payload\"\nmass_kg = 3\n"
      "[[effect]]\nname = \"joint-position\"\nbase_um = [[1,2,3],[4,5,6],[7,8,9],[0,0,0],[0,0,0],[0,0,0]]\n"
      "platform_um = [[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,-2]]\n");
  CHECK(model.instances().size() == kBaseEffects + 3);
  const auto at = [&](const char* effect, const char* key, int i) {
    return model.parameters[static_cast<std::size_t>(model.find(effect, key) + i)];
  };
  CHECK(at("platform-gravity", "mass_kg", 0) == 100);
  CHECK(at("platform-gravity", "centre_of_mass_mm", 2) == Approx(0.35796));
  CHECK(at("strut-gravity", "screw_length_mm", 5) == Approx(1.5));
  CHECK(at("screw-friction", "coulomb_friction_N", 2) == 160);
  CHECK(at("backlash", "width_um", 0) == Approx(4e-6));
  CHECK(at("backlash", "width_um", 5) == Approx(1e-6));
  CHECK(at("payload", "mass_kg", 0) == 3);
  CHECK(at("joint-position", "base_um", 5) == Approx(6e-6));
  CHECK(at("joint-position", "platform_um", 17) == Approx(-2e-6));
  CHECK(model.machine.lead[3] == Approx(0.02));
  CHECK(model.machine.middle_length[0] == Approx(1.3));
  CHECK(model.environment().sign_speed == Approx(2e-5));
}

TEST_CASE("an effect may be there twice, and be added later") {
  ForceModel model =
      with_rows("[[effect]]\nname = \"payload\"\nmass_kg = 3\n[[effect]]\nname = \"payload\"\nmass_kg = 4\n");
  CHECK(model.instances_of(effect_index("payload")).size() == 2);
  CHECK(model.find("strut-offset", "length_um") == -1);
  const int first = model.add("strut-offset");
  CHECK(model.find("strut-offset", "length_um") == first);
  CHECK(model.parameters.size() == static_cast<std::size_t>(first) + 6);
  CHECK_THROWS_AS(model.add("no-such-effect"), InternalError);
  CHECK_THROWS_AS(model.add("platform-gravity"), InternalError);
}

TEST_CASE("rows that make no sense are refused where they stand") {
  check_bad_files(source_path("tests/physics/bad"), 13,
                  [](const std::string& path) { ForceModel(machine::read_model(path)); });
}
