#include "settings/settings_file.hpp"

#include <catch2/catch.hpp>

#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using settings::Options;

TEST_CASE("a settings file gives options, its paths count from its own folder") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("plumbline.toml", R"(plumbline = "settings 1"
model = "machine.toml"
tools = "/tools.toml"
step_length = 0.5
time_tolerance = 0.002
no_friction = true
block_delete = true
tool_in_spindle = 3
pass = ["M428", "M429"]
keeps_position = "M6"
touch_off = [0, 0, -1008, 0, 0, 0]
start = {A = 0, B = 1.5}
[work_offset]
G54 = [0, 0, -1008, 0, 0, 0.5]
"G59.3" = "1,2,3,4,5,6"
)");
  Options options;
  settings::read_settings_file(path, options);
  CHECK(options.paths.model == scratch.path("machine.toml"));
  CHECK(options.paths.tools == "/tools.toml");
  CHECK(options.compensation.step.length_mm == 0.5);
  CHECK(options.emit.time_tolerance == 0.002);
  CHECK_FALSE(options.compensation.friction);
  CHECK(options.program.block_delete == true);
  CHECK(options.program.tool_in_spindle == 3);
  CHECK(options.program.passed_m_codes == std::set{428, 429});
  CHECK(options.program.keeps_position == std::set{6});
  CHECK(options.compensation.touch_off == AxisWords{{0, 0, -1008, 0, 0, 0}});
  CHECK(options.program.start[4] == 1.5);
  CHECK_FALSE(options.program.start[5]);
  CHECK(options.program.work_offsets[0]->origin == AxisWords{{0, 0, -1008, 0, 0, 0.5}});
  CHECK(options.program.work_offsets[8]->origin == AxisWords{{1, 2, 3, 4, 5, 6}});
  CHECK(options.paths.settings_file == path);
}

TEST_CASE("work offsets may be an array of texts") {
  const testing::Scratch scratch;
  Options options;
  settings::read_settings_file(scratch.file("s",
                                            "plumbline = \"settings 1\"\nwork_offset = [\"G54=0,0,1,0,0,0\", "
                                            "\"G55=0,0,2,0,0,0\"]\n"),
                               options);
  CHECK(options.program.work_offsets[0]->origin[Axis::Z] == 1);
  CHECK(options.program.work_offsets[1]->origin[Axis::Z] == 2);
}

TEST_CASE("what is given already is checked but not taken") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("s", "plumbline = \"settings 1\"\nstep_length = 0.5\nstep_angle = 0.2\n");
  Options options;
  settings::read_settings_file(path, options, [](const settings::OptionRow& row) { return row.name == "step-length"; });
  CHECK(options.compensation.step.length_mm == 1.0);
  CHECK(options.compensation.step.angle_deg == 0.2);
}

TEST_CASE("a settings file may state a tolerance, but not steps beside it") {
  const testing::Scratch scratch;
  Options options;
  settings::read_settings_file(
      scratch.file("s", "plumbline = \"settings 1\"\ntolerance = \"0.5um\"\nyields = \"time\"\n"), options);
  CHECK(options.compensation.bound.tolerance_mm == Approx(0.0005));
  CHECK(options.compensation.bound.yields == compensate::BoundSettings::Yields::time);
  for (const char* const other : {"step_length = 1", "step_angle = 0.2", "friction_turn = 0.1", "first_order = true"}) {
    INFO(other);
    const std::string path =
        scratch.file("s", std::string("plumbline = \"settings 1\"\n") + other + "\ntolerance = \"0.5um\"\n");
    Options both;
    const Diagnostic said = testing::refusal_of([&] { settings::read_settings_file(path, both); });
    CHECK(said.code == "settings-value");
    CHECK(said.place.line == 3);
  }
}

TEST_CASE("errors of a settings file have their place") {
  struct Case {
    const char* text;
    const char* code;
    std::size_t line;
  };
  const testing::Scratch scratch;
  for (const Case& c :
       {Case{"step_length = 1\n", "settings-kind", 1}, Case{"plumbline = \"machine 1\"\n", "settings-kind", 1},
        Case{"plumbline = \"settings 1\"\nsteplength = 1\n", "settings-key", 2},
        Case{"plumbline = \"settings 1\"\nstep_length = -1\n", "settings-value", 2},
        Case{"plumbline = \"settings 1\"\n[work_offset]\nG54 = [0,0,0,0,0,0]\nG60 = [0,0,0,0,0,0]\n", "settings-value",
             4},
        Case{"plumbline = \"settings 1\"\npass = [\n\"M428\",\n\"428\"]\n", "settings-value", 4},
        Case{"plumbline = \"settings 1\"\ndialect = \"klingon\"\n", "settings-value", 2},
        Case{"plumbline = \"settings 1\"\nstep_length = 1979-05-27\n", "settings-type", 2},
        Case{"plumbline = \"settings 1\"\n\nwork_offset = {G54 = [1, 2]}\n", "settings-value", 3},
        Case{"plumbline = \"settings 1\"\nstep_length = {}\n", "settings-type", 2},
        Case{"plumbline = \"settings 1\"\nstep_length = \n", "toml-syntax", 2}}) {
    INFO(c.text);
    Options options;
    const Diagnostic d = testing::refusal_of([&] { settings::read_settings_file(scratch.file("s", c.text), options); });
    CHECK(d.code == c.code);
    CHECK(d.place.line == c.line);
  }
}

TEST_CASE("the settings file is looked for beside the program") {
  const testing::Scratch scratch;
  CHECK(settings::settings_file_beside(scratch.path("p.ngc")).empty());
  const std::string path = scratch.file("plumbline.toml", "");
  CHECK(settings::settings_file_beside(scratch.path("p.ngc")) == path);
  CHECK(settings::settings_file_beside("-").empty());
}
