#include "jobs/program/open_program.hpp"

#include <catch2/catch.hpp>

#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

machine::MachineModel given_model() { return machine::read_model(testing::source_file("models/pm600-like.toml")); }

}  // namespace

TEST_CASE("without a machine, what nobody gave is zero; for one it stays open") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("p.ngc", "G21\nG0 X1\nM2\n");
  const jobs::OpenedProgram alone = jobs::open_program({}, path);
  CHECK(alone.settings.as_with_empty_tables);
  CHECK(alone.file.name() == path);
  CHECK(alone.dialect.name == "linuxcnc");
  const jobs::OpenedProgram on_machine = jobs::open_program({}, path, given_model());
  CHECK_FALSE(on_machine.settings.as_with_empty_tables);
  CHECK(on_machine.settings.rotation_order == given_model().rotation.axes);
}

TEST_CASE("A, B and C turn as the model that the options name says") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("p.ngc", "G0 X1\nM2\n");
  std::string model = read_text(testing::source_file("models/pm600-like.toml"));
  const std::size_t order = model.find("\"ZYX\"");
  REQUIRE(order != std::string::npos);
  settings::Options options;
  options.paths.model = scratch.file("m.toml", model.replace(order, 5, "\"XYZ\""));
  CHECK(jobs::open_program({}, path).settings.rotation_order == nc::RotationOrder{2, 1, 0});
  CHECK(jobs::open_program(options, path).settings.rotation_order == nc::RotationOrder{0, 1, 2});
}

TEST_CASE("tables that the options name are read, and the dialect is the one that they say") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("p.nc", "G0 X1\nM2\n");
  settings::Options options;
  options.dialect = "okuma";
  options.paths.tools = scratch.file("tools.toml", "plumbline = \"tools 1\"\n\n[[tool]]\nnumber = 3\nlength_mm = 85\n");
  const jobs::OpenedProgram opened = jobs::open_program(options, path);
  CHECK(opened.dialect.name == "okuma");
  REQUIRE(opened.settings.tools.find(3) != nullptr);
  CHECK(opened.settings.tools.find(3)->length_mm == 85);
}

TEST_CASE("a program, a table or a model that is not there is refused by name") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("p.ngc", "G0 X1\nM2\n");
  CHECK(testing::refusal_of([&] { jobs::open_program({}, scratch / "none.ngc"); }).place.file == scratch / "none.ngc");
  settings::Options options;
  options.paths.model = scratch / "none.toml";
  CHECK(testing::refusal_of([&] { jobs::open_program(options, path); }).place.file == scratch / "none.toml");
  options.paths = {};
  options.paths.tools = scratch / "tools.toml";
  CHECK(testing::refusal_of([&] { jobs::open_program(options, path, given_model()); }).code == "file-missing");
}

TEST_CASE("a shift of all work systems in the variables of a Fanuc is refused, as it is not added") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("p.nc", "O1\nG54 G0 X1.\nM30\n");
  settings::Options options;
  options.dialect = "fanuc";
  for (const std::string variable : {"#5201 3", "#5203 -0.4", "#5206 1"}) {
    options.paths.variables = scratch.file("v", variable + "\n");
    CHECK(testing::refusal_of([&] { jobs::open_program(options, path); }).code == "variables-offset");
    options.dialect = "linuxcnc";
    CHECK(jobs::open_program(options, path).dialect.name == "linuxcnc");
    options.dialect = "fanuc";
  }
  options.paths.variables = scratch.file("v", "#5201 0\n");
  CHECK(jobs::open_program(options, path).dialect.name == "fanuc");
}
