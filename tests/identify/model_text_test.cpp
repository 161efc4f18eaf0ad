#include "identify/model_text.hpp"

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

std::string pm600_text() { return read_text(source_path("models/pm600-like.toml")); }

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

double& parameter(physics::ForceModel& forces, const char* effect, const char* key, int i = 0) {
  return forces.parameters[static_cast<std::size_t>(forces.find(effect, key) + i)];
}

void set_all(physics::ForceModel& forces, const char* effect, const char* key, double value) {
  for (int i = 0; i < 6; ++i) parameter(forces, effect, key, i) = value;
}

}  // namespace

TEST_CASE("nothing changed: the text stays byte for byte") {
  const std::string text = pm600_text();
  const machine::MachineModel machine = machine::parse_model(text, "m.toml");
  CHECK(model_text(machine, {physics::ForceModel(machine), {}, "", {}}) == text);
}

TEST_CASE("new numbers take the places of old ones, and all other bytes stay") {
  const std::string text = replaced(pm600_text(), "coulomb_friction_N = [110, 130, 160, 130, 160, 160]",
                                    "coulomb_friction_N = [110, 130,  # greased\r\n  160, 130, 160, 160]");
  const machine::MachineModel machine = machine::parse_model(text, "m.toml");
  physics::ForceModel forces(machine);
  parameter(forces, "screw-friction", "coulomb_friction_N", 1) = 127.25;
  parameter(forces, "screw-friction", "coulomb_friction_N", 5) = 0.04;  // would be taken for a slip of units
  set_all(forces, "axial-elasticity", "compliance_um_N", 7.5e-9);
  parameter(forces, "platform-gravity", "centre_of_mass_mm", 1) = -0.0005;
  std::string expected =
      replaced(text, "110, 130,  # greased\r\n  160, 130, 160, 160", "110, 127.25,  # greased\r\n  160, 130, 160, 0");
  expected = replaced(expected, "compliance_um_N = 0.00782", "compliance_um_N = 0.0075");
  expected = replaced(expected, "centre_of_mass_mm = [0, 0, 357.96]", "centre_of_mass_mm = [0, -0.5, 357.96]");
  CHECK(model_text(machine, {forces, {}, "", {}}) == expected);
  parameter(forces, "axial-elasticity", "compliance_um_N", 3) = 8e-9;
  expected = replaced(expected, "compliance_um_N = 0.0075",
                      "compliance_um_N = [0.0075, 0.0075, 0.0075, 0.008, 0.0075, 0.0075]");
  CHECK(model_text(machine, {forces, {}, "", {}}) == expected);
}

TEST_CASE("a number that new-model assumed is no longer called so") {
  std::string text =
      replaced(pm600_text(), "compliance_um_N = 0.00782", "compliance_um_N = 0.00782  # assumed: a guess");
  text = replaced(text, "lead_mm = 20", "lead_mm = 20  # assumed: another");
  text = replaced(text, "mass_kg = 100", "mass_kg = 100  # weighed, not assumed: by us");
  const machine::MachineModel machine = machine::parse_model(text, "m.toml");
  physics::ForceModel forces(machine);
  set_all(forces, "axial-elasticity", "compliance_um_N", 7.5e-9);
  parameter(forces, "platform-gravity", "mass_kg") = 101;
  std::string expected = replaced(text, "compliance_um_N = 0.00782  # assumed: a guess",
                                  "compliance_um_N = 0.0075  # fitted; before, assumed: a guess");
  expected = replaced(expected, "mass_kg = 100 ", "mass_kg = 101 ");
  CHECK(model_text(machine, {forces, {}, "", {}}) == expected);
}

TEST_CASE("effects: known rows get new numbers, new ones are added, what changes nothing is not") {
  const std::string text =
      pm600_text() + "\n[[effect]]\nname = \"backlash\" # seen by eye\nwidth_um = [1, 0, 0, 0, 0, 0]\n";
  const machine::MachineModel machine = machine::parse_model(text, "m.toml");
  physics::ForceModel forces(machine);
  forces.add("level");
  forces.add("strut-offset");
  parameter(forces, "backlash", "width_um", 2) = 3.5e-6;
  parameter(forces, "level", "tilt_mrad", 1) = -0.123456789e-3;
  const std::string written = model_text(machine, {forces, {}, "", {"why\nand what else", ""}});
  CHECK(written == replaced(text, "[1, 0, 0, 0, 0, 0]", "[1, 0, 3.5, 0, 0, 0]") +
                       "\n[[effect]]\nname = \"level\"\ntilt_mrad = [0, -0.123456789]\n\n# why\n# and what else\n#\n");
  const physics::ForceModel again(machine::parse_model(written, "m.toml"));
  CHECK(again.instances().size() == forces.instances().size() - 1);
  for (std::size_t i = 0; i < again.parameters.size(); ++i) CHECK(again.parameters[i] == Approx(forces.parameters[i]));
}

TEST_CASE("nested arrays are written and replaced number by number") {
  const machine::MachineModel machine = pm600_like();
  physics::ForceModel forces(machine);
  forces.add("joint-position");
  parameter(forces, "joint-position", "platform_um", 7) = 2.25e-6;
  const std::string once = model_text(machine, {forces, {}, "", {}});
  CHECK(once.find("platform_um = [[0, 0, 0], [0, 0, 0], [0, 2.25, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]") !=
        std::string::npos);
  const machine::MachineModel second = machine::parse_model(once, "m.toml");
  physics::ForceModel more(second);
  parameter(more, "joint-position", "base_um", 17) = -1e-6;
  CHECK(model_text(second, {more, {}, "", {}}) ==
        replaced(once, "[0, 0, 0]]\nplatform_um", "[0, 0, -1]]\nplatform_um"));
}

TEST_CASE("keys that the file left out come into their tables, or tables of their own") {
  const std::string with_table = replaced(pm600_text(), "viscous_friction_Nms_rad = 0\n", "");
  machine::MachineModel machine = machine::parse_model(with_table, "m.toml");
  physics::ForceModel forces(machine);
  parameter(forces, "joint-friction", "viscous_friction_Nms_rad") = 1.5;
  CHECK(model_text(machine, {forces, {}, "", {}}) ==
        replaced(with_table, "[joint]\n", "[joint]\nviscous_friction_Nms_rad = 1.5\n"));
  const std::string without = replaced(with_table, "[joint]\n", "");
  machine = machine::parse_model(without, "m.toml");
  parameter(forces, "joint-friction", "coulomb_friction_Nm") = 2;
  CHECK(model_text(machine, {forces, {}, "", {}}) ==
        without + "\n[joint]\nviscous_friction_Nms_rad = 1.5\ncoulomb_friction_Nm = 2\n");
  const std::string in_line = replaced(without, "rotation =", "joint = { coulomb_friction_Nm = 1 }\nrotation =");
  machine = machine::parse_model(in_line, "m.toml");
  CHECK(model_text(machine, {forces, {}, "", {}}) ==
        replaced(in_line, "{ coulomb_friction_Nm = 1", "{viscous_friction_Nms_rad = 1.5,  coulomb_friction_Nm = 2"));
}

TEST_CASE("numbers are rounded to a hundredth of their standard error") {
  const machine::MachineModel machine = pm600_like();
  physics::ForceModel forces(machine);
  std::vector<double> errors(forces.parameters.size(), 0);
  parameter(forces, "platform-gravity", "mass_kg") = 101.23456789;
  errors[static_cast<std::size_t>(forces.find("platform-gravity", "mass_kg"))] = 0.3;
  CHECK(model_text(machine, {forces, errors, "", {}}).find("\nmass_kg = 101.235\n") != std::string::npos);
}

TEST_CASE("provenance is told, in whatever quotes") {
  const auto told = [](const std::string& before, const std::string& after) {
    const std::string line = pm600_text().substr(pm600_text().find("provenance"));
    const std::string whole = line.substr(0, line.find('\n'));
    const machine::MachineModel machine = machine::parse_model(replaced(pm600_text(), whole, before), "m.toml");
    CHECK(model_text(machine, {physics::ForceModel(machine), {}, "by a \"test\"", {}}) ==
          replaced(pm600_text(), whole, after));
  };
  told("provenance = \"assumed\" # all", "provenance = \"assumed; by a test\" # all");
  told("provenance = 'assumed'", "provenance = 'assumed; by a test'");
  told("provenance = \"\"\"\nassumed\"\"\"", "provenance = \"\"\"\nassumed; by a test\"\"\"");
  told("provenance = \"\"", "provenance = \"by a test\"");
  const std::string silent = replaced(pm600_text(), "provenance", "# provenance");
  CHECK(model_text(machine::parse_model(silent, "m.toml"),
                   {physics::ForceModel(machine::parse_model(silent, "m.toml")), {}, "by a test", {}}) ==
        replaced(silent, "\"pm600-like\"\n", "\"pm600-like\"\nprovenance = \"by a test\"\n"));
}
