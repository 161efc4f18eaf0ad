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

TEST_CASE("where M6 changes tools, D takes no length of a tool that T only prepared") {
  check_refused({{"G54 T1 D1\nG0 X0 Y0 Z50\nT2\nM6\nM30\n", 4, 1, "nc-tool-unknown"},
                 {"G54 T1\nD1\nG0 X0 Y0 Z50\nG1 Z5 F100\nM6\nM30\n", 5, 1, "nc-tool-unknown"}});
  for (const char* const text : {"G54 T1 D1\nG0 X0 Y0 Z50\nM30\n", "G54 T1 D1\nM6\nG0 X0 Y0 Z50\nM30\n",
                                 "G54 T1\nM6\nD1\nG0 X0 Y0 Z50\nT1\nM6\nM30\n",
                                 "G54 T=\"A\" M6\nD1\nG0 X0 Y0 Z50\nT=\"B\"\nM6\nD1\nG0 X5\nM30\n",
                                 "G54 T=\"A\"\nM6\nD1\nG0 X0 Y0 Z50\nT0\nM6\nM30\n"}) {
    INFO(text);
    CHECK(outcome_of(text).code.empty());
  }
}

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
                 {"G54 G0 X0 Y0 Z9\nG93 F1\nCYCLE81(9,0,2,-5)\n", 3, 1},
                 {"G54 G0 X0 Y0 Z9\nCYCLE81(9,0,2,-5)\n", 2, 1, "nc-feed-missing"}});
}

TEST_CASE("a block without axis words makes no hole") {
  const Outcome ran = outcome_of(
      "G54 G0 X0 Y0 Z9\nF100\nMCALL CYCLE81(9,0,2,-5)\nM8\nG90\nMSG(\"here\")\nX1\nMCALL\nS900 M3\nG0\nF200\n");
  CHECK(ran.code.empty());
  CHECK(ran.motions.size() == 5);  // G0, and of the hole: there, to R, down and back
  for (const std::string dwell : {"G4 F1", "G4 S5", "N9 G4 F0.5 ; chips"}) {
    INFO(dwell);
    const Outcome waits =
        outcome_of("G54 G0 X0 Y0 Z9\nF100 S900 M3\nMCALL CYCLE81(9,0,2,-5)\nX1\n" + dwell + "\nMCALL\n");
    CHECK(waits.code.empty());
    CHECK(waits.motions.size() == 6);
  }
  // Of these a control is said to make one.
  check_refused({{"G54 G0 X0 Y0 Z9 F1\nMCALL CYCLE81(9,0,2,-5)\nF200\n", 3, 1},
                 {"G54 G0 X0 Y0 Z9 F1\nMCALL CYCLE81(9,0,2,-5)\nM8 S900\n", 3, 4},
                 {"G54 G0 X0 Y0 Z9 F1\nMCALL CYCLE82(9,0,2,-5)\nX1\nG90 G1\n", 4, 5}});
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
  // With a direction, and where C stands said, the tool goes back to where it stands upright.
  ProgramSettings stays = at_zero();
  stays.free_rotation = FreeRotation::c_stays;
  for (const char* const line : {"CYCLE800(0,\"\",0,27,0,0,0,0,0,0,0,0,0,1)",
                                 "N7 CYCLE800(1,\"TC1\",100000,57,0,0,0,0,0,0,0,0,0,-1,100,1) ; off"}) {
    INFO(line);
    const ProgramFile program(
        fmt::format("G54 G0 X0 Y0 Z9 A0 B0 C7\nCYCLE800(1,\"\",0,57,0,0,0,5,3,0,0,0,0,1)\n{}\nG0 X1 A0 B0\n", line));
    const InputFile file(program.path());
    Program blocks(file, dialect("siemens"), stays);
    blocks.next();
    CHECK(blocks.next()->motions.back().to[Axis::A] != 0);
    const Step& upright = *blocks.next();
    CHECK(upright.known == AxisSet{Axis::A, Axis::B, Axis::C});
    CHECK(upright.motions.back().to[Axis::A] == Approx(0).margin(1e-9));
    CHECK(upright.motions.back().to[Axis::B] == Approx(0).margin(1e-9));
    CHECK(upright.motions.back().to[Axis::C] == Approx(7));
    CHECK_FALSE(upright.frame->tilted);
    CHECK(blocks.next()->known.contains(Axis::X));
  }
  check_refused({{"N1 CYCLE800(0,\"\",0,27,0,0,0,0,0,0,5,0,0,1)\n", 1, 35, "nc-tilted-plane"},
                 {"R1=5\nCYCLE800(0,,0,27,0,0,0,0,9,0,0,R1*2)\n", 2, 32, "nc-tilted-plane"},
                 {"CYCLE800(0,\"\",0,58,0,0,0,0,9,0,0,0,0,1)\n", 1, 17, "nc-tilted-plane"},
                 {"CYCLE800(0,\"\",0,57,0,0,0,0,9,0,0,0,0,2)\n", 1, 38, "nc-tilted-plane"}});
}

TEST_CASE("CASE goes on at the label of its value, or where DEFAULT says") {
  const auto ends_at = [](int value) {
    const Outcome ran =
        outcome_of(fmt::format("G54 G0 X0\nR1={}\nCASE R1 OF 1 GOTOF ONE 2 GOTOF TWO -3 GOTOF TWO DEFAULT GOTOF REST ; "
                               "which\nX9\nREST: X8\nM30\n"
                               "ONE: X1\nM30\nTWO: X2\nM30\n",
                               value));
    INFO(ran.code << " " << ran.line);
    return ran.motions.empty() ? -1.0 : ran.motions.back().to[Axis::X];
  };
  CHECK(ends_at(1) == 1);
  CHECK(ends_at(2) == 2);
  CHECK(ends_at(-3) == 2);
  CHECK(ends_at(7) == 8);
  CHECK(outcome_of("G54 G0 X0\nCASE 5 OF 1 GOTOB BACK\nX3\n").motions.back().to[Axis::X] == 3);
  CHECK(outcome_of("R1=0\nAGAIN: G54 G0 X=R1\nR1=R1+1\nCASE R1 OF 1 GOTOB AGAIN 2 GOTOB AGAIN\n").motions.size() == 3);
  check_refused({{"CASE 1 IS 1 GOTOF ONE\n", 1, 1, "nc-flow-control"},
                 {"CASE 1 OF 1 X5\n", 1, 1, "nc-flow-control"},
                 {"G54 G0 X0\nCASE 1 OF 1 GOTOF NOWHERE\n", 2, 1, "nc-flow-label"}});
}

TEST_CASE("parts of a program are repeated by their labels") {
  const auto path = [](const std::string& text) {
    std::string ends;
    const Outcome ran = outcome_of("G54 G0\n" + text);
    INFO(text << ran.code << " " << ran.line);
    CHECK(ran.code.empty());
    for (const Motion& motion : ran.motions) ends += fmt::format("{} ", motion.to[Axis::X]);
    return ends;
  };
  CHECK(path("X1\nPART: X2\nX3\nREPEAT PART\nX4\n") == "1 2 3 2 3 4 ");
  CHECK(path("PART: X2\nX3\nREPEAT PART P=2\nX4\n") == "2 3 2 3 2 3 4 ");
  CHECK(path("PART: X2\nX3\nENDLABEL:\nX5\nREPEAT PART P1\nX4\n") == "2 3 5 2 3 4 ");
  CHECK(path("ONE: X2\nX3\nTWO: X4\nX5\nREPEAT ONE TWO P=2\nX6\n") == "2 3 4 5 2 3 4 2 3 4 6 ");
  CHECK(path("HOLE: G91 X1\nG90 Y1\nREPEATB HOLE P=3\nG90 X9\n") == "1 1 2 3 4 9 ");
  CHECK(path("OUT: X1\nIN: X2\nREPEATB IN\nX3\nREPEAT OUT\nX9\n") == "1 2 2 3 1 2 2 3 9 ");
  CHECK(path("PART: X2\nKURZ\nREPEAT PART\nM30\n%_N_KURZ_SPF\nX7\nX8\nM17\n") == "2 7 8 2 7 8 ");
  check_refused({{"G54 G0\nX1\nREPEAT PART P=3\nPART: X2\n", 3, 1},
                 {"G54 G0\nX1\nREPEATB PART\nX3\nPART: X2\n", 3, 1},
                 {"G54 G0\nONE: X1\nREPEAT ONE TWO\nTWO: X2\n", 3, 1},
                 {"G54 G0\nX1\nREPEAT PART P=3\n", 3, 1, "nc-flow-label"},
                 {"G54 G0\nPART: X1\nR1=R1+1\nIF R1==2 GOTOF OUT\nREPEAT PART P=3\nOUT: X2\n", 4, 1},
                 {"G54 G0\nTWO: X1\nONE: X2\nREPEAT ONE TWO\n", 4, 1, "nc-flow-label"},
                 {"REPEATB P=3\n", 1, 1, "nc-flow-control"},
                 {"AA: G54 G0\nREPEAT AB BC CD\n", 2, 1, "nc-flow-control"}});
}

TEST_CASE("programs called by EXTCALL are looked for beside the program, by their name alone") {
  for (const char* const call :
       {R"n(EXTCALL("KURZ"))n", R"(EXTCALL "KURZ.SPF")", R"(N5 EXTCALL ("//srv/nc\part/kurz.spf") ; it)"}) {
    const Outcome ran = outcome_of(fmt::format("G54 G0 X1\n{}\nX3\nM30\n%_N_KURZ_SPF\nX7\nRET\n", call));
    INFO(call << " " << ran.code << " " << ran.line);
    REQUIRE(ran.motions.size() == 3);
    CHECK(ran.motions[1].to[Axis::X] == 7);
  }
  check_refused({{"EXTCALL(NAME)\n", 1, 1},
                 {"EXTCALL(\"\")\n", 1, 1, "nc-flow-control"},
                 {"G54 G0 X1\nEXTCALL(\"NOWHERE\")\n", 2, 1, "nc-flow-open"}});
}

TEST_CASE("G58 shifts the axes that it names") {
  const auto display = [](const char* text) {
    const Outcome ran = outcome_of(text);
    INFO(text << ran.code << " " << ran.line);
    REQUIRE_FALSE(ran.motions.empty());
    return ran.motions.back().machine;
  };
  CHECK(display("G54 G0 X0 Y0\nG58 X10\nX1 Y2\n") == AxisWords{{11, 2, 0, 0, 0, 0}});
  CHECK(display("G54 G0\nTRANS X5 Y6\nG58 Y1\nX1 Y2\n") == AxisWords{{6, 3, 0, 0, 0, 0}});
  CHECK(display("G54 G0\nG58 X5\nTRANS Z3\nX1 Z2\n") == AxisWords{{1, 0, 5, 0, 0, 0}});
  check_refused({{"G54 G0 X0\nG58\n", 2, 1},
                 {"G54 G0 X0\nATRANS X1\nG58 X2\n", 3, 1},
                 {"G54 G0 X0\nROT RPL=30\nG58 X2\n", 3, 1},
                 {"G54 G0 X0\nG59 X2\n", 2, 1}});
}

TEST_CASE("spindles by number: the first is the spindle, others and other codes are refused") {
  for (const char* const line : {"S1=900 M1=3", "M1=4 S500", "M1=19", "N3 M1=41"}) {
    INFO(line);
    CHECK(outcome_of(fmt::format("G54 G0 X0\n{}\nG1 X1 F100\nM1=5\nM30\n", line)).code.empty());
  }
  CHECK(outcome_of("G54 G0 X0\nS1=900 M1=3\nG95 G1 X1 F0.1\n").motions.back().feed_mode == FeedMode::per_revolution);
  check_refused({{"M2=3\n", 1, 1},
                 {"G54 G0 X0 S2=900\n", 1, 11},
                 {"M1=8\n", 1, 1},
                 {"T2=5\n", 1, 1},
                 {"M1=30\n", 1, 1},
                 {"G0 POS[X]=10\n", 1, 4},
                 {"POSA[Z]=5 FA[Z]=100\n", 1, 1}});
}

TEST_CASE("where G53 puts the tip while a tool's length is in force is not known") {
  const auto known_after = [](const std::string& text) {
    const ProgramFile program(text);
    const InputFile file(program.path());
    ProgramSettings settings = with_offsets();
    settings.as_with_empty_tables = false;
    settings.keeps_position = {6};
    for (auto& start : settings.start) start = 0;
    AxisSet known;
    Program blocks(file, dialect("siemens"), settings);
    while (const Step* step = blocks.next()) known = step->known;
    return known;
  };
  const std::string tool = "T1 M6\nG54 G0 X0 Y0 Z50 A0 B0 C0\n";
  CHECK(known_after(tool + "SUPA G0 Z500\n") == AxisSet::all() - AxisSet{Axis::Z});
  CHECK(known_after(tool + "G153 G0 X1 Y1\n") == AxisSet::all() - AxisSet{Axis::X, Axis::Y});
  CHECK(known_after(tool + "SUPA G0 Z500 D0\n") == AxisSet::all());
  CHECK(known_after(tool + "G53 G0 Z500\nG0 Z9\n") == AxisSet::all());
}

TEST_CASE("a tool changed while D0 is in force leaves open which edge counts, until D says it") {
  check_refused({{"G54 G0 X0 Y0 Z50 D0\nT1\nM6\nX5\nZ10\n", 5, 1},
                 {"G54 G0 X0 Y0 Z50 D0\nT1 M6\nG91 G1 X1 Z-1 F100\n", 3, 11},
                 {"G54 G0 X0 Y0 Z50 D0\nT1 M6\nTRAORI\nG1 X5 A3 F100\n", 4, 7}});
  for (const char* program :
       {"G54 G0 X0 Y0 Z50 D0\nT1\nM6\nX5 Y5\nZ10 D1\nZ5\n", "G54 G0 SUPA Z50 D0\nT1 M6\nG0 SUPA Z20\nD1\nX5 Z5\n",
        "G54 G0 X0 Y0 Z50 D0\nT1 M6\nTRAORI\nX5 A3\nZ10 D1\n", "G54 G0 Z50 D0\nT1 M6\nD0 Z20\n"}) {
    INFO(program);
    CHECK(outcome_of(program).code.empty());
  }
}

TEST_CASE("where the tool is tilted, a change of its length moves X and Y of the tip as well") {
  const auto known_after = [](const std::string& text) {
    const ProgramFile program("G54 G0 X0 Y0 Z50 " + text);
    const InputFile file(program.path());
    ProgramSettings settings = with_offsets();
    settings.as_with_empty_tables = false;
    settings.keeps_position = {6};
    AxisSet known;
    Program blocks(file, dialect("siemens"), settings);
    while (const Step* step = blocks.next()) known = step->known;
    return known;
  };
  const AxisSet turns{Axis::A, Axis::B, Axis::C};
  CHECK(known_after("A0 B0 C9 D0\nT1 M6\nD1\n") == AxisSet::all());
  CHECK(known_after("A5 B0 C0 D0\nT1 M6\nD1\n") == turns);
  CHECK(known_after("A5 B0 C0 D0\nT1 M6\nD1\nG0 Y7\n") == (turns | AxisSet{Axis::Y}));
  CHECK(known_after("A0 B0 C0 D0\nT1 M6\nG0 B-4\nG0 X1 Z9 D1\n") == (turns | AxisSet{Axis::X, Axis::Z}));
  CHECK(known_after("A0 B0 C0\nT1 M6\nG0 B-4 X3\nD0\n") == turns);
  CHECK(known_after("A0 B2 C0 D0\nT1 M6\nG0 Y1\n") == (turns | AxisSet{Axis::Y}));
}

TEST_CASE("R parameters that were never given are zero where tables count as empty") {
  for (const std::string text : {"IF R1==0\nG0 X5\nENDIF\n", "G0 X=5+R3\n", "IF R1<>0 GOTOF AA1\nG0 X5\nAA1:\n",
                                 "R2=R1\nIF R2>=0\nG0 X5\nENDIF\n"}) {
    const Outcome ran = outcome_of("G54 G71 G90 G94 G17\nG0 X0 Y0 Z0\n" + text + "M30\n");
    INFO(text);
    CHECK(ran.code.empty());
    REQUIRE(ran.motions.size() == 2);
    CHECK(ran.motions.back().to[Axis::X] == 5);
  }
}
