// What a SINUMERIK makes of its programs, case by case: where it is refused, or where its moves end.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

ProgramSettings with_offsets() {
  ProgramSettings settings = empty_tables();
  for (int i = 0; i < 3; ++i) {  // G54, G55, G56
    settings.work_offsets[static_cast<std::size_t>(i)] = WorkOffset{};
    settings.work_offsets[static_cast<std::size_t>(i)]->origin[Axis::X] = 10.0 * i;
    settings.work_offsets[static_cast<std::size_t>(i)]->origin[Axis::Z] = -1.0 * i;
  }
  Tool tool;
  tool.number = 1;
  tool.length_mm = 100;
  settings.tools = ToolTable({tool});
  return settings;
}

struct Outcome {
  std::string code;  // of the refusal
  std::size_t line = 0, column = 0;
  std::vector<Motion> motions;
};

Outcome outcome_of(const std::string& text) {
  const ProgramFile program(text);
  const InputFile file(program.path());
  Outcome ran;
  try {
    Program blocks(file, dialect("siemens"), with_offsets());
    while (const Step* step = blocks.next()) {
      ran.motions.insert(ran.motions.end(), step->motions.begin(), step->motions.end());
    }
  } catch (const Refusal& refusal) {
    ran.code = refusal.diagnostic().code;
    ran.line = refusal.diagnostic().place.line;
    ran.column = refusal.diagnostic().place.column;
    CHECK_FALSE(refusal.diagnostic().help.empty());
  }
  return ran;
}

struct Refused {
  const char* program;
  std::size_t line, column;
  const char* code = "nc-not-interpreted";
};

void check_refused(const std::vector<Refused>& cases) {
  for (const Refused& c : cases) {
    const Outcome ran = outcome_of(c.program);
    INFO(c.program);
    CHECK(ran.code == c.code);
    CHECK(ran.line == c.line);
    CHECK(ran.column == c.column);
  }
}

}  // namespace

TEST_CASE("an increment after a change of offsets is refused until an absolute word made the axis follow") {
  check_refused({{"G54 G0 X0 Y0 Z0\nTRANS X10\nG91 X5\n", 3, 5},
                 {"G54 G0 X0 Y0 Z0\nG55\nG1 Y1 X=IC(5) F100\n", 3, 7},
                 {"G54 G0 X0 Y0 Z50\nG91 D1 T1\nM6\nG90 X0 Y0 Z50\nD0\nG91 Z-10\n", 6, 5},
                 {"G54 G0 X0 Y0 Z0\nTRANS Y3\nATRANS X1\nG90 G1 Y0 F100\nX=IC(1)\n", 5, 1},
                 {"G54 G0 X5 Y0 Z0\nAROT RPL=30\nG91 G1 X1 F100\n", 3, 8},
                 {"G55 G0 X0 Y0 Z0\nSUPA G0 Z9\nG91 Z-1\n", 3, 5},
                 {"G54 G0 X0 Y0 Z0\nTRANS X10\nG91 G2 X2 I1 F100\n", 3, 8}});
}

TEST_CASE("increments of axes that no change of offsets touched, or that followed it, are read") {
  const auto end = [](const char* text) {
    const Outcome ran = outcome_of(text);
    INFO(text << " " << ran.code << " " << ran.line);
    REQUIRE_FALSE(ran.motions.empty());
    CHECK(ran.code.empty());
    return ran.motions.back();
  };
  CHECK(end("G54 G0 X0 Y0 Z0\nTRANS X10\nG91 Y5\n").to[Axis::Y] == 5);
  CHECK(end("G54 G0 X0 Y0 Z0\nTRANS X10\nX0\nG91 X5\n").machine[Axis::X] == 15);
  CHECK(end("G54 G0 X0 Y0 Z0\nG55\nX=AC(1)\nX=IC(2)\n").machine[Axis::X] == 13);
  CHECK(end("G54 G0 X0 Y0 Z0\nTRANS\nG91 X5\n").machine[Axis::X] == 5);  // nothing changed
  CHECK(end("T1 M6 D1\nG54 G0 X0 Y0 Z50\nG91 G1 Z-10 F100\n").machine[Axis::Z] == 140);
}

TEST_CASE("G4 stands alone, F does not stand beside a change of units") {
  check_refused({{"G54 G0 X0\nG4 F2 X10\n", 2, 7},
                 {"G54 G0 X0\nG1 G4 F2\n", 2, 1},
                 {"G54 G0 X0\nG4 S30 M8\n", 2, 8},
                 {"G54 G0 X0\nD1 G4 F1\n", 2, 1},
                 {"G54 G0 X0\nG700 F10\n", 2, 6},
                 {"G700 G54 G0 X0\nG1 X1 G710 F500\n", 2, 12},
                 {"G700 G54 G0 X0\nG1 F=5*2 G71 X1\n", 2, 4}});
  CHECK(outcome_of("G710 G54 G0 X0\nG710 G1 X1 F500\n").code.empty());  // no change
  CHECK(outcome_of("G54 G0 X0\nN10 G4 F2 ; a pause\n").motions.back().dwell_s == 2);
}

TEST_CASE("G97 and G973 leave a feed per revolution in force, G971 one per minute") {
  for (const char* const code : {"G97", "G973", "G95"}) {
    const Outcome ran = outcome_of(fmt::format("G54 G0 X0\nS1000 M3\n{} G1 X10 F0.2\n", code));
    INFO(code << " " << ran.code);
    REQUIRE(ran.motions.size() == 2);
    CHECK(ran.motions.back().feed_mode == FeedMode::per_revolution);
    CHECK(ran.motions.back().feed == 0.2);
  }
  CHECK(outcome_of("G54 G0 X0\nG971 G1 X10 F200\n").motions.back().feed_mode == FeedMode::per_minute);
  check_refused({{"G54 G0 X0\nS1000 M3\nG94 F500\nG97\nG1 X10\n", 5, 1, "nc-feed-missing"},
                 {"G54 G0 X0\nG972 G1 X10 F200\n", 2, 1},
                 {"G54 G0 X0\nG94 G97 G1 X10 F200\n", 2, 5, "nc-same-group"},
                 {"G54 G0 X0\nG93 G971 G1 X10 F200\n", 2, 5, "nc-same-group"}});
}

TEST_CASE("calls of cycles that no source covers are refused") {
  const std::string begin = "G54 G0 X0 Y0 Z50\nF100\n";
  struct Case {
    const char* line;
    std::size_t column = 1;
    const char* code = "nc-not-interpreted";
  };
  for (const Case& c :
       {Case{"CYCLE81(10,0,2)"}, Case{"CYCLE81(10,0,2,-5,7)"}, Case{"CYCLE81(10,0,2,-5,,0,0,20)"},
        Case{"CYCLE82(10,0,2,-5,,1,1)"}, Case{"CYCLE82(10,0,2,-5,,1,0,2)"}, Case{"CYCLE82(10,0,2,-5,,1,0,0,1)"},
        Case{"CYCLE82(10,0,2,-5,,1,0,0,0,1)"}, Case{"CYCLE83(10,0,2,-5,,-2,,0,0,0,1,1,1)"},
        Case{"CYCLE84(10,0,2,-5,,0,3)"}, Case{"CYCLE84(10,0,2,-5,,0,3,,20,0,400,400,,2)"},
        Case{"CYCLE81(10,0,2,5)", 1, "nc-out-of-range"}, Case{"CYCLE81(-1,0,2,-5)", 1, "nc-out-of-range"},
        Case{"G0 X1 CYCLE81(10,0,2,-5)"}, Case{"MCALL CYCLE81(10,0,2,-5) X1", 26}, Case{"F100 MCALL"},
        Case{"MCALL L100", 7}, Case{"MCALL BOHREN(1,2)", 7}, Case{"CYCLE81(10,0,2,-5", 1, "nc-bracket-open"},
        Case{"CYCLE81(10,0,2,-5) CYCLE82(10,0,2,-5)", 20, "nc-flow-control"}}) {
    const Outcome ran = outcome_of(begin + c.line + "\n");
    INFO(c.line);
    CHECK(ran.code == c.code);
    CHECK(ran.line == 3);
    CHECK(ran.column == c.column);
  }
  check_refused({{"G54 G0 X0 Y0 Z9\nMCALL CYCLE81(9,0,2,-5)\nF100 G2 X2 I1\n", 3, 6},
                 {"G54 G0 X0 Y0 Z9 F1\nMCALL CYCLE81(9,0,2,-5)\nSUPA G0 Z0\n", 3, 6},
                 {"G54 G0 X0 Y0 Z9 F1\nMCALL CYCLE81(9,0,2,-5)\nCYCLE82(9,0,2,-5)\n", 3, 1},
                 {"G54 G0 X0 Y0 Z9 F1 R1=2\nMCALL CYCLE81(9,0,R1,-5)\nR1=3\n", 3, 1},
                 {"G54 G0 X0 Y0 Z9\nG93\nCYCLE81(9,0,2,-5)\n", 3, 1},
                 {"G54 G0 X0 Y0 Z9\nCYCLE81(9,0,2,-5)\n", 2, 1, "nc-feed-missing"}});
}

TEST_CASE("swivel cycles that turn nothing leave the axes where nobody knows, others are refused") {
  for (const char* const line :
       {"CYCLE800()", "CYCLE800", "CYCLE800(0,\"\",0,27,0,0,0,0,0,0,0,0,0,1)",
        "N7 CYCLE800(1,\"TC1\",100000,57,0,0,0,0,0,0,0,0,0,-1,100,1) ; off", "CYCLE800(4,\"0\",,)"}) {
    const ProgramFile program(fmt::format("G54 G0 X0 Y0 Z9 A0 B0 C0\n{}\nG0 X1\n", line));
    const InputFile file(program.path());
    Program blocks(file, dialect("siemens"), at_zero());
    INFO(line);
    CHECK(blocks.next()->known == AxisSet::all());
    CHECK(blocks.next()->known.empty());
    CHECK(blocks.next()->known == AxisSet{Axis::X});
  }
  check_refused({{"CYCLE800(1,\"TC1\",0,57,0,0,0,0,30,0,0,0,0,-1,100,1)\n", 1, 31},
                 {"N1 CYCLE800(0,\"\",0,27,5,0,0,0,0,0,0,0,0,1)\n", 1, 23},
                 {"R1=5\nCYCLE800(0,,0,27,0,0,0,0,0,R1*2)\n", 2, 28}});
}
