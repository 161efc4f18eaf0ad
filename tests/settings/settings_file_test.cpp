#include "settings/settings_file.hpp"

#include <catch2/catch.hpp>

#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using settings::Options;

namespace {

// What a file states for every machine.
Options options_of(const std::string& path) {
  Options options;
  for (const settings::StatedOption& stated : settings::read_settings_file(path).options)
    settings::set_option(options, *stated.row, stated.text);
  return options;
}

}  // namespace

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
  const Options options = options_of(path);
  CHECK(options.paths.model.path() == scratch.path("machine.toml"));
  CHECK(options.paths.tools.path() == "/tools.toml");
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
  CHECK(settings::read_settings_file(path).path == path);
}

TEST_CASE("work offsets may be an array of texts") {
  const testing::Scratch scratch;
  const Options options = options_of(scratch.file("s",
                                                  "plumbline = \"settings 1\"\nwork_offset = [\"G54=0,0,1,0,0,0\", "
                                                  "\"G55=0,0,2,0,0,0\"]\n"));
  CHECK(options.program.work_offsets[0]->origin[Axis::Z] == 1);
  CHECK(options.program.work_offsets[1]->origin[Axis::Z] == 2);
}

TEST_CASE("a settings file may state a tolerance, but not steps beside it") {
  const testing::Scratch scratch;
  const Options options =
      options_of(scratch.file("s", "plumbline = \"settings 1\"\ntolerance = \"0.5um\"\nyields = \"time\"\n"));
  CHECK(options.compensation.bound.tolerance_mm == Approx(0.0005));
  CHECK(options.compensation.bound.yields == compensate::BoundSettings::Yields::time);
  for (const char* const other : {"step_length = 1", "step_angle = 0.2", "friction_turn = 0.1", "first_order = true"}) {
    INFO(other);
    const std::string path =
        scratch.file("s", std::string("plumbline = \"settings 1\"\n") + other + "\ntolerance = \"0.5um\"\n");
    const Diagnostic said = testing::refusal_of([&] { settings::read_settings_file(path); });
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
        Case{"plumbline = \"settings 1\"\nmachines = 3\n", "settings-type", 2},
        Case{"plumbline = \"settings 1\"\nmachine = [1]\n", "settings-type", 2},
        Case{"plumbline = \"settings 1\"\n[machines]\nhex = 3\n", "settings-type", 3},
        Case{"plumbline = \"settings 1\"\n[machines.hex]\nmodle = \"m.toml\"\n", "settings-key", 3},
        Case{"plumbline = \"settings 1\"\n[machines.hex]\nstep_length = 1\ntolerance = \"1um\"\n", "settings-value", 4},
        Case{"plumbline = \"settings 1\"\noutput_name = \"out.ngc\"\n", "settings-value", 2},
        Case{"plumbline = \"settings 1\"\nstep_length = \n", "toml-syntax", 2}}) {
    INFO(c.text);
    const Diagnostic d = testing::refusal_of([&] { settings::read_settings_file(scratch.file("s", c.text)); });
    CHECK(d.code == c.code);
    CHECK(d.place.line == c.line);
  }
}

TEST_CASE("a settings file describes machines, each with its options") {
  const testing::Scratch scratch;
  const settings::SettingsFile file = settings::read_settings_file(scratch.file("s", R"(plumbline = "settings 1"
machine = "hex-3"
step_length = 0.5
[machines.hex-3]
model = "hex-3.toml"
output_name = "out/{name}{ext}"
[machines.hex-3.work_offset]
G54 = [0, 0, -1008, 0, 0, 0]
[machines.hex-4]
output_name = "{folder}/{name}_{machine}{ext}"
)"));
  CHECK(file.machine == "hex-3");
  CHECK(file.machine_place.line == 2);
  REQUIRE(file.options.size() == 1);
  REQUIRE(file.machines.size() == 2);
  const std::vector<settings::StatedOption>& third = file.machines.at("hex-3");
  REQUIRE(third.size() == 3);
  CHECK(third[0].text == scratch.path("hex-3.toml"));
  CHECK(third[1].text == scratch.path("out/{name}{ext}"));
  CHECK(third[2].text == "G54=0,0,-1008,0,0,0");
  CHECK(third[2].place.line == 8);
  CHECK(file.machines.at("hex-4")[0].text == "{folder}/{name}_{machine}{ext}");
}

TEST_CASE("a settings file says one thing of a work system, an axis, a rule") {
  const testing::Scratch scratch;
  for (const char* const text : {"work_offset = [\"G54=0,0,0,0,0,0\", \"G54=1,0,0,0,0,0\"]",
                                 "[work_offset]\nG54 = [0, 0, 0, 0, 0, 0]\ng54 = [0, 0, 0, 0, 0, 1]",
                                 "[start]\nA = 0\na = 1", "rotary = [\"C=sign\", \"C=linear\"]"}) {
    INFO(text);
    const std::string path = scratch.file("plumbline.toml", std::string("plumbline = \"settings 1\"\n") + text + "\n");
    const Diagnostic refused = testing::refusal_of([&] { settings::read_settings_file(path); });
    CHECK(refused.code == "settings-value");
    CHECK(refused.place.line > 1);
  }
}
