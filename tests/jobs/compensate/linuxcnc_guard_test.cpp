#include <algorithm>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "jobs/compensate/guard_block.hpp"
#include "jobs/program/survey_program.hpp"
#include "nc/language/guard_lines.hpp"
#include "support/scratch.hpp"
#include "support/skip.hpp"

using namespace plumbline;

namespace {

const nc::Tool kTool{2, 50, {}, {}, {}, ""};
constexpr const char* kTable = "T1 P1 Z3.3464567\nT2 P2 Z1.9685039\n";  // inch: rs274's machine is one in inches

// What stands in a control before the program, as blocks and as its tool table, and the program's settings.
struct ControlState {
  std::string blocks = "G21 G90\n";
  std::string tools = kTable;
};

nc::ProgramSettings given(std::map<int, double> variables = {}) {
  nc::ProgramSettings settings;
  settings.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  settings.work_offsets[1] = nc::WorkOffset{{{5, 7, -1000, 0, 0, 0}}, 30};
  settings.variables = std::move(variables);
  return settings;
}

std::vector<std::string> guard_of(const testing::Scratch& scratch, const std::string& program,
                                  const nc::ProgramSettings& settings) {
  jobs::OpenedProgram opened = jobs::open_program({}, scratch.file("program.ngc", program));
  opened.settings = settings;
  return jobs::guard_block(settings, jobs::survey_program(opened));
}

// Whether rs274 reaches what stands behind the guard, and in which state.
struct Run {
  bool passed = false;
  std::string end;  // "#5220 #5210 #<_tool_offset>" behind the guard
};

Run run(const std::string& program, const nc::ProgramSettings& settings, const ControlState& control) {
  const testing::Scratch scratch;
  std::string text = "G10 L2 P1 X0 Y0 Z[-1008*#<_metric>-1008/25.4*#<_imperial>]\nG21\n";
  text += "G10 L2 P1 X0 Y0 Z-1008 A0 B0 C0\nG10 L2 P2 X5 Y7 Z-1000 A0 B0 C0 R30\n" + control.blocks;
  for (const std::string& line : guard_of(scratch, program, settings)) {
    INFO(line);
    CHECK(line.size() <= nc::dialect("linuxcnc").line_length);
    if (line.front() != '(') CHECK(nc::is_part_of_guard(line, nc::dialect("linuxcnc")));
    text += line + "\n";
  }
  scratch.file("p.ngc", text + "(DEBUG,reached #5220 #5210 #<_tool_offset>)\nM2\n");
  scratch.file("tools.tbl", control.tools);
  scratch.file("v.var", "");
  const std::string command = "cd " + scratch.path("") + " && HOME=" + scratch.path("") +
                              " rs274 -g -n 2 -t tools.tbl -v v.var p.ngc canon >log 2>&1";
  CHECK(std::system(command.c_str()) == 0);
  INFO(scratch.text("log"));
  const std::string canon = scratch.text("canon");
  Run result;
  const std::size_t reached = canon.find("reached ");
  result.passed = reached != std::string::npos;
  CHECK(result.passed == (canon.find("plumbline guard") == std::string::npos));
  if (result.passed) result.end = canon.substr(reached + 8, canon.find('"', reached) - reached - 8);
  return result;
}

constexpr const char* kStated = "G21 G90 G94\nG0 X0 Y0 Z20 A0 B0 C0\nM2\n";

}  // namespace

TEST_CASE("LinuxCNC: a guard asks for the work system that was given, and leaves it") {
  if (!testing::has_rs274_or_skips()) return;
  for (const int system : {1, 2, 9}) {
    const nc::ProgramSettings settings = given({{5220, system}});
    const std::string name = system == 9 ? "G59.3" : "G5" + std::to_string(3 + system);
    const Run as_given = run(kStated, settings, {.blocks = "G21 G90 " + name + "\n"});
    CHECK(as_given.passed);
    CHECK(as_given.end == std::to_string(system) + ".000000 0.000000 0.000000");
    CHECK_FALSE(run(kStated, settings, {.blocks = "G21 G90 G56\n"}).passed);
  }
}

TEST_CASE("LinuxCNC: a guard compares the tool in the spindle where that was given") {
  if (!testing::has_rs274_or_skips()) return;
  nc::ProgramSettings settings = given();
  settings.tools = nc::ToolTable({kTool});
  settings.tool_in_spindle = 2;
  for (const char* const program : {kStated, "G21 G90\nG43\nG0 X0 Y0 Z20 A0 B0 C0\nM2\n"}) {
    CHECK(run(program, settings, {.blocks = "G21 G90\nT2 M6\n"}).passed);
    CHECK_FALSE(run(program, settings, {.blocks = "G21 G90\nT1 M6\n"}).passed);
    CHECK_FALSE(run(program, settings, {}).passed);
  }
  settings.tool_in_spindle.reset();
  CHECK(run(kStated, settings, {.blocks = "G21 G90\nT1 M6\n"}).passed);
}

TEST_CASE("LinuxCNC: a guard compares the G92 that is in force, or kept and brought back, and leaves it") {
  if (!testing::has_rs274_or_skips()) return;
  const std::map<int, double> kept{{5211, -3}, {5212, 0}, {5213, 2}, {5214, 0}, {5215, 0}, {5216, 4}};
  nc::ProgramSettings settings = given(kept);
  settings.variables[5210] = 1;
  const std::string set = "G21 G90\nG0 X0 Y0 Z0 A0 B0 C0\nG92 X3 Y0 Z-2 A0 B0 C-4\n";
  const Run in_force = run(kStated, settings, {.blocks = set});
  CHECK(in_force.passed);
  CHECK(in_force.end == "1.000000 1.000000 0.000000");
  CHECK(run(kStated, settings, {.blocks = set + "G0 X7 Y3 C8\nG20\n"}).passed);
  CHECK_FALSE(run(kStated, settings, {.blocks = set + "G92.2\n"}).passed);
  CHECK_FALSE(run(kStated, settings, {.blocks = set + "G92 X3.1\n"}).passed);
  CHECK_FALSE(run(kStated, settings, {.blocks = set + "G92 C-4.01\n"}).passed);
  CHECK_FALSE(run(kStated, settings, {}).passed);

  settings.variables[5210] = 0;
  const std::string brings_back = "G21 G90 G94\nG0 X0 Y0 Z20 A0 B0 C0\nG92.3\nG0 X1\nM2\n";
  const Run suspended = run(brings_back, settings, {.blocks = set + "G92.2\n"});
  CHECK(suspended.passed);
  CHECK(suspended.end == "1.000000 0.000000 0.000000");
  CHECK_FALSE(run(brings_back, settings, {.blocks = set + "G92 X3.1\nG92.2\n"}).passed);
  CHECK_FALSE(run(brings_back, settings, {.blocks = set}).passed);
  CHECK_FALSE(run(brings_back, settings, {}).passed);
  CHECK(run(kStated, settings, {}).passed);  // nothing brings it back
  settings = given({{5210, 1}, {5211, 3}});
  const testing::Scratch scratch;
  CHECK(testing::refusal_of([&] { guard_of(scratch, kStated, settings); }).code == "guard-g92");
}

TEST_CASE("LinuxCNC: a guard that stops leaves the G92 that it found") {
  if (!testing::has_rs274_or_skips()) return;
  const testing::Scratch scratch;
  nc::ProgramSettings settings = given({{5211, 1}, {5212, 0}, {5213, 0}, {5214, 0}, {5215, 0}, {5216, 0}});
  for (const double in_force : {0.0, 1.0}) {
    settings.variables[5210] = in_force;
    const std::vector<std::string> lines = guard_of(scratch, "G21 G90 G94\nG92.3\nG0 X1\nM2\n", settings);
    bool now = in_force == 1;
    bool inside = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool sets = lines[i].starts_with("G92.");
      if (lines[i].find("> if [") != std::string::npos) inside = true;
      if (lines[i] == "M2") CHECK((now == (in_force == 1) || lines[i - 2] == (in_force == 1 ? "G92.3" : "G92.2")));
      if (sets && !inside) now = lines[i] == "G92.3";
      if (lines[i].find("> endif") != std::string::npos) inside = false;
    }
    CHECK(now == (in_force == 1));
  }
}

TEST_CASE("LinuxCNC: a guard compares all offsets of a tool, not its length alone") {
  if (!testing::has_rs274_or_skips()) return;
  nc::ProgramSettings settings = given();
  settings.tools = nc::ToolTable({kTool});
  const std::string program = "G21 G90 G94\nG43 H2\nG0 X0 Y0 Z20 A0 B0 C0\nM2\n";
  CHECK(run(program, settings, {}).passed);
  CHECK(run(program, settings, {.blocks = "G21 G90\nG55\nG0 X3 Y4 C5\nG54\n"}).passed);
  for (const char* const other : {"X0.1", "Y-0.2", "A0.5", "B-0.5", "C1", "U0.1", "V0.1", "W-0.1"}) {
    INFO(other);
    CHECK_FALSE(run(program, settings, {.tools = "T2 P2 Z1.9685039 " + std::string(other) + "\n"}).passed);
  }
  CHECK_FALSE(run(program, settings, {.tools = "T2 P2 Z1.9689\n"}).passed);
}

TEST_CASE("LinuxCNC: a guard compares the modes that the program does not state before its first move") {
  if (!testing::has_rs274_or_skips()) return;
  const auto passes = [](const std::string& program, const std::string& modes) {
    return run(program, given(), {.blocks = "G21 G90 G94\n" + modes + "\n"}).passed;
  };
  const std::string move = "G0 X0 Y0 Z20 A0 B0 C0\nM2\n";
  for (const std::string& program :
       {"G90 G94 G54\n" + move, "G94 G90\n" + move + "G21\n", "G90\nF500\nG94 G21\n" + move,
        "G90 G94\nG4 P1\nG10 L2 P3 X1\nG21\n" + move, "G90 G94\n/G21\n" + move, "G90 G94\n#1=21\nG#1\n" + move}) {
    INFO(program);
    CHECK(passes(program, ""));
    CHECK_FALSE(passes(program, "G20"));
  }
  for (const std::string& program : {"G21 G94\n" + move, "G21\nG0 X0 Y0 Z9 A0 B0 C0\nG90\n" + move}) {
    INFO(program);
    CHECK(passes(program, ""));
    CHECK_FALSE(passes(program, "G91"));
  }
  CHECK_FALSE(passes("G21 G90\n" + move, "G93"));
  for (const std::string& program :
       {"G20 G91 G95\n" + move, "%\n(head)\nN10 G17 G21\nN20 G90\nN30 T1 M6\nG94 " + move, "#3=4\nG21 G90 G94 " + move,
        "o100 sub\nG1 X1 F100\no100 endsub\nG21 G90 G94\n" + move, "G90 G94 F200 G21\n" + move}) {
    INFO(program);
    CHECK(passes(program, "G20"));
    CHECK(passes(program, "G91"));
    CHECK(passes(program, "G93"));
  }
  nc::ProgramSettings in_inches = given();
  in_inches.inches = true;
  CHECK(run("G90 G94\n" + move, in_inches, {.blocks = "G20 G90 G94\n"}).passed);
  CHECK_FALSE(run("G90 G94\n" + move, in_inches, {.blocks = "G21 G90 G94\n"}).passed);
}

TEST_CASE("LinuxCNC: a guard compares the start that was given, where the first move does not reach it by itself") {
  if (!testing::has_rs274_or_skips()) return;
  nc::ProgramSettings settings = given();
  settings.start = {1, 2, 30, 0, 0, 5};
  const std::string there = "G21 G90\nG0 X1 Y2 Z30 C5\n";
  for (const char* const program :
       {"G21 G90 G94\nG1 X5 Y5 Z20 A0 B0 C0 F500\nM2\n", "G21 G90 G94\nG0 Z50\nG0 X0 Y0 A0 B0 C0\nM2\n",
        "G21 G91 G94\nG0 X0 Y0 Z20 A0 B0 C0\nM2\n", "G21 G90 G94\nG28 X0 Y0\nG0 X0 Y0 Z20 A0 B0 C0\nM2\n"}) {
    INFO(program);
    CHECK(run(program, settings, {.blocks = there}).passed);
    CHECK(run(program, settings, {.blocks = there + "G20\n"}).passed);
    CHECK_FALSE(run(program, settings, {.blocks = there + "G0 X1.01\n"}).passed);
  }
  CHECK_FALSE(run("G21 G90 G94\nG0 X0 Y0 Z20 A0 B0\nM2\n", settings, {.blocks = there + "G0 C4\n"}).passed);
  CHECK(run(kStated, settings, {.blocks = there + "G0 X-8 Y3 Z7 C2\n"}).passed);
}
