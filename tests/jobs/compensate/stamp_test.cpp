#include "jobs/compensate/stamp.hpp"

#include <catch2/catch.hpp>

#include "base/version.hpp"
#include "jobs/program/used_tools.hpp"
#include "machine/model_file.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

std::vector<std::string> stamp_of(const settings::Options& options, const std::string& model_name = "pm600-like") {
  machine::MachineModel model = machine::read_model(testing::source_file("models/pm600-like.toml"));
  model.name = model_name;
  nc::ProgramSettings program;
  program.work_offsets[0] = nc::WorkOffset{{{0, 0.5, -1008, 0, 0, 0}}, 30};
  program.start[4] = 2;
  const std::vector<nc::Tool> tools{{1, 85, 16, 1.4, 22}, {2, 60.5, {}, {}, {}}};
  return jobs::stamp(options, program, model, {nc::dialect("linuxcnc"), AxisSet::all(), tools});
}

std::vector<int> used_numbers(const std::string& program, const nc::ToolTable& table,
                              std::optional<int> spindle = std::nullopt) {
  std::vector<int> found;
  const InputFile file(program);
  for (const nc::Tool& tool : jobs::used_tools(file, table, spindle)) found.push_back(tool.number);
  return found;
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

}  // namespace

TEST_CASE("a stamp says what the output was made with and holds for") {
  settings::Options options;
  options.compensation.friction = false;
  options.program.block_delete = true;
  options.paths.settings_files = {"part/plumbline.toml"};
  options.compensation.touch_off = AxisWords{{1, 2, 3, 0, 0, 0}};
  const std::vector<std::string> lines = stamp_of(options);
  CHECK(lines.front() == "plumbline " + std::string(plumbline::version()) + " compensated this program");
  CHECK(lines[1].starts_with("model pm600-like, hash "));
  CHECK(
      has(lines, "method exact, friction off, step 0.1 deg or 1 mm, time tolerance 0.001 of a block, block delete on"));
  CHECK(has(lines, "touch-off at X1 Y2 Z3 A0 B0 C0"));
  CHECK(has(lines, "settings file part/plumbline.toml"));
  CHECK(has(lines, "start at B2"));
  CHECK(has(lines, "G54 X0 Y0.5 Z-1008 A0 B0 C0 R30"));
  CHECK(has(lines, "tool 1: length 85 mm, mass 1.4 kg at 22 mm"));
  CHECK(has(lines, "tool 2: length 60.5 mm, mass not stated"));
}

TEST_CASE("a stamp says in which state the control starts where that is not the usual one") {
  const machine::MachineModel model = machine::read_model(testing::source_file("models/pm600-like.toml"));
  compensate::ProgramSurvey survey{nc::dialect("linuxcnc"), AxisSet::all()};
  const auto lines_of = [&](const nc::ProgramSettings& program) { return jobs::stamp({}, program, model, survey); };
  nc::ProgramSettings program;
  const std::size_t usual = lines_of(program).size();
  program.variables = {{5210, 0}, {5211, 3}, {5220, 1}};
  CHECK(lines_of(program).size() == usual);
  program.variables = {{5220, 2}};
  CHECK(has(lines_of(program), "starts in G55"));
  program.variables = {{5210, 1}, {5211, -0.5}, {5213, 2}, {5216, 4}};
  CHECK(has(lines_of(program), "G92 in force: shift X-0.5 Y0 Z2 A0 B0 C4"));
  program.variables[5210] = 0;
  survey.beginning.may_restore_g92 = true;
  CHECK(has(lines_of(program), "G92 kept for G92.3: shift X-0.5 Y0 Z2 A0 B0 C4"));
  program = {};
  program.tool_in_spindle = 2;
  CHECK(has(lines_of(program), "tool 2 in the spindle at the start"));
}

TEST_CASE("whatever a name holds, a stamp is plain short comments") {
  const std::string odd = "M2) G0 X99 (DEBUG, %\n;\xC3\xA4" + std::string(400, 'n') + " end";
  for (const std::string& line : stamp_of({}, odd)) {
    INFO(line);
    CHECK(line.size() <= 100);
    CHECK(line.find_first_of("();%\n\r") == std::string::npos);
    CHECK(std::all_of(line.begin(), line.end(), [](char c) { return c >= 0x20 && c < 0x7F; }));
    for (const char* const active : {"MSG", "DEBUG", "PRINT", "LOG", "PROBE", "PY", "AXIS"}) {
      CHECK_FALSE(line.starts_with(active));
    }
  }
}

TEST_CASE("the tools of a program are those whose numbers stand in it") {
  const testing::Scratch scratch;
  const nc::ToolTable table({{1, 10, {}, {}, {}}, {2, 20, {}, {}, {}}, {3, 30, {}, {}, {}}, {12, 40, {}, {}, {}}});
  const auto numbers = [&](const char* program, std::optional<int> spindle = {}) {
    return used_numbers(scratch.file("p.ngc", program), table, spindle);
  };
  CHECK(numbers("t 1 2 m6 (T1)\n; T2\nG43h03\n") == std::vector{3, 12});
  CHECK(numbers("G1X1\n").empty());
  CHECK(numbers("G1X1\n", 2) == std::vector{2});
  CHECK(numbers("M61 Q1\n") == std::vector{1});
  CHECK(numbers("T#<tool> M6\n").size() == 4);
  CHECK(numbers("G43 H[1+1]\n").size() == 4);
}

TEST_CASE("tools that a program calls by name are those that the table gives this name") {
  const testing::Scratch scratch;
  nc::Tool mill{1, 10, {}, {}, {}};
  mill.name = "MILL10";
  const nc::ToolTable table({mill, {2, 20, {}, {}, {}}});
  const auto numbers = [&](const char* program) { return used_numbers(scratch.file("p.mpf", program), table); };
  CHECK(numbers("T=\"MILL10\" D1\n") == std::vector{1});
  CHECK(numbers("T = \"2\" D1\n") == std::vector{2});
  CHECK(numbers("T=\"MILL8\"\nT=\"\n").empty());
  CHECK(numbers("T=R1\n").size() == 2);
}

TEST_CASE("the tools of subprograms beside a program are its own") {
  const testing::Scratch scratch;
  const nc::ToolTable table({{1, 10, {}, {}, {}}, {2, 20, {}, {}, {}}, {3, 30, {}, {}, {}}, {12, 40, {}, {}, {}}});
  scratch.file("drill.ngc", "o<drill> sub\nT2 M6\no100 call\no<drill> endsub\n");
  scratch.file("100.ngc", "o100 sub\nG43 H3\no100 endsub\n");
  scratch.file("other.ngc", "T12 M6\n");
  const auto numbers = [&](const char* name, const char* program) {
    return used_numbers(scratch.file(name, program), table);
  };
  CHECK(numbers("p.ngc", "T1 M6\no<drill> call\n(other)\n") == std::vector{1, 2, 3});
  CHECK(numbers("p.nc", "M98 P0100\n") == std::vector{3});
  CHECK(numbers("p.mpf", "DRILL(1)\n") == std::vector{2, 3});
  CHECK(numbers("p.ngc", "G1 X100 L5\n").empty());
}
