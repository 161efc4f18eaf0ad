// What codes do, one small program a family: the last of the moves that it makes, worked out by hand, and a program
// that the family refuses. Whole families are held by programs of their dialects beside what they must mean:
// tests/nc/programs (NAME.canon is LinuxCNC's own), tests/nc/fanuc, okuma and siemens (NAME.trace), tests/nc/bad;
// called_tap and called_after by tests/nc/siemens_feeds_test.cpp.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

struct Family {
  std::string_view file;  // in src/nc/control/families
  std::string_view dialect;
  std::string_view program;
  std::string_view kinds;  // of its motions: rapid, feed, arc, probe, dwell; + : any number of the last
  AxisWords to;            // of the last one, in the work system
  AxisWords machine;       // and on the control's display, with all offsets
  double feed;             // of the last one
  std::string_view refused;
  std::string_view code;
};

// Where all offsets are zero the display shows the work system.
Family in_place(std::string_view file, std::string_view dialect, std::string_view program, std::string_view kinds,
                const AxisWords& to, double feed, std::string_view refused, std::string_view code) {
  return {file, dialect, program, kinds, to, to, feed, refused, code};
}

std::vector<Motion> family_motions(std::string_view program, std::string_view dialect_name) {
  const ProgramFile written(program);
  const InputFile file(written.path());
  Program steps(file, dialect(dialect_name), empty_tables());
  std::vector<Motion> motions;
  while (const Step* const step = steps.next())
    motions.insert(motions.end(), step->motions.begin(), step->motions.end());
  return motions;
}

std::string kinds_of(const std::vector<Motion>& motions) {
  std::string kinds;
  for (const Motion& motion : motions) kinds += "rfapd"[static_cast<std::size_t>(motion.kind)];
  return kinds;
}

void check_words(const AxisWords& is, const AxisWords& expected) {
  for (const Axis axis : kAllAxes) {
    INFO(letter(axis));
    CHECK(is[axis] == Approx(expected[axis]).margin(1e-9));
  }
}

void check_family(const Family& family) {
  INFO(family.file);
  const std::vector<Motion> motions = family_motions(family.program, family.dialect);
  REQUIRE_FALSE(motions.empty());
  std::string kinds = kinds_of(motions);
  if (family.kinds.ends_with('+')) {
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    kinds += '+';
  }
  CHECK(kinds == family.kinds);
  check_words(motions.back().to, family.to);
  check_words(motions.back().machine, family.machine);
  CHECK(motions.back().feed == Approx(family.feed));
  const Diagnostic refused = testing::refusal_of([&] { family_motions(family.refused, family.dialect); });
  CHECK(refused.code == family.code);
  CHECK(refused.place.line ==
        static_cast<std::size_t>(std::count(family.refused.begin(), family.refused.end(), '\n')));  // its last line
}

const std::string_view kTilted = "CYCLE800(1,\"TABLE\",0,57,0,0,0,0,30,0,0,0,0,-1)\nG0 X10 Y0 Z4\n";

}  // namespace

TEST_CASE("moves: straight, along circles and splines, led by the spindle, to a probe") {
  for (const Family& family : {
           in_place("straight.cpp", "linuxcnc", "G0 X1 Y2\nG1 Z-3 F100\n", "rf", {{1, 2, -3, 0, 0, 0}}, 100,
                    "G91\nG53 G0 X1\n", "nc-machine-move"),
           in_place("moves.cpp", "linuxcnc", "G0 X1\nG91 X2\nG90 @10 ^90\n", "rrr", {{0, 10, 0, 0, 0, 0}}, 0, "G1 X1\n",
                    "nc-feed-missing"),
           in_place("motion_modes.cpp", "linuxcnc", "G0 X1\nG80\nG1 X2 F100\n", "rf", {{2, 0, 0, 0, 0, 0}}, 100,
                    "G0 X1\nG80\nX2\n", "nc-axes-unused"),
           in_place("feed_words.cpp", "linuxcnc", "G93 G1 X1 F2\nG94 F30 X4\n", "ff", {{4, 0, 0, 0, 0, 0}}, 30,
                    "G1 X1 F30\nG93\nX2\n", "nc-feed-missing"),
           in_place("arcs.cpp", "linuxcnc", "G2 X10 Z-1 I5 F100\n", "a", {{10, 0, -1, 0, 0, 0}}, 100, "F100\nG2 X10\n",
                    "nc-arc-words"),
           in_place("splines.cpp", "linuxcnc", "F100\nG5.1 X10 Y4 I5 J5\n", "f+", {{10, 4, 0, 0, 0, 0}}, 100,
                    "F100\nG5.3\n", "nc-out-of-range"),
           in_place("synchronised.cpp", "linuxcnc", "S100 M3\nG33 Z-5 K1.5\n", "f", {{0, 0, -5, 0, 0, 0}}, 1.5,
                    "G33 Z-5 K1\n", "nc-feed-missing"),
           in_place("probe.cpp", "linuxcnc", "G38.2 Z-10 F50\n", "p", {{0, 0, -10, 0, 0, 0}}, 50, "F50\nG38.2\n",
                    "nc-axes-missing"),
           in_place("increments.cpp", "fanuc", "G0 X1500 Y2.\n", "r", {{1.5, 2, 0, 0, 0, 0}}, 0, "G20\nG1 X1. F10\n",
                    "nc-value-unknown"),
       }) {
    check_family(family);
  }
}

TEST_CASE("offsets, frames and tools change the display, not the words") {
  for (const Family& family : {
           Family{"offsets.cpp",
                  "linuxcnc",
                  "G10 L2 P1 X10\nG92 X5\nG0 X1\n",
                  "r",
                  {{1, 0, 0, 0, 0, 0}},
                  {{-4, 0, 0, 0, 0, 0}},
                  0,
                  "G92\n",
                  "nc-axes-missing"},  // X stood on 0: -10, which became 5
           Family{"frames.cpp",
                  "fanuc",
                  "G0 X0 Y0 Z10.\nG68 X10. Y0 R90.\nG1 X20. Y0 F100\n",
                  "rf",
                  {{20, 0, 10, 0, 0, 0}},
                  {{10, 10, 10, 0, 0, 0}},
                  100,
                  "G54.1 P301\n",
                  "nc-out-of-range"},
           // about X: Y 20 cos 30 - 5 sin 30, Z 20 sin 30 + 5 cos 30
           Family{"tilted_plane.cpp",
                  "fanuc",
                  "G68.2 X0 Y0 Z0 I0 J30. K0\nG53.1\nG0 X10. Y20. Z5.\n",
                  "rr",
                  {{10, 20, 5, 30, 0, 0}},
                  {{10, 14.820508075689, 14.330127018922, 30, 0, 0}},
                  0,
                  "G53.1\n",
                  "nc-tilted-plane"},
           // about Y: X 10 cos 30 + 4 sin 30, Z 4 cos 30 - 10 sin 30
           Family{"swivel.cpp",
                  "siemens",
                  kTilted,
                  "rr",
                  {{10, 0, 4, 0, 30, 0}},
                  {{10.660254037844, 0, -1.535898384862, 0, 30, 0}},
                  0,
                  "CYCLE800(1,\"TABLE\",0,58,0,0,0,0,30,0,0,0,0,-1)\n",
                  "nc-tilted-plane"},
           // C has turned the axes by 90 degrees: I is towards -Y of the machine, so that A leans by atan(1/2)
           in_place("tool_vector.cpp", "fanuc", "G0 X0. A0. B0. C90.\nG43.5 H1 Z50.\nG1 X20. I1. J0. K2. F500.\n",
                    "rrf", {{20, 0, 50, 26.565051177078, 0, 90}}, 500, "G0 X0.\nG43.5 H1 Z50.\nX1. I0. J0. K0.\n",
                    "nc-tool-vector"),
           Family{"tools.cpp",
                  "linuxcnc",
                  "G43.1 Z8\nG0 Z1\n",
                  "r",
                  {{0, 0, 1, 0, 0, 0}},
                  {{0, 0, 9, 0, 0, 0}},
                  0,
                  "T-1\n",
                  "nc-negative"},
           Family{"tool_table.cpp",
                  "linuxcnc",
                  "G10 L1 P3 Z10\nT3 M6\nG43\nG0 Z2\n",
                  "r",
                  {{0, 0, 2, 0, 0, 0}},
                  {{0, 0, 12, 0, 0, 0}},
                  0,
                  "G10 L1 P3\n",
                  "nc-axes-missing"},
           in_place("homes.cpp", "okuma", "G15 H1\nG0 X10.\nG20 HP=4\nG0 X0 Y1. Z0\n", "rr", {{0, 1, 0, 0, 0, 0}}, 0,
                    "G15 H1\nG20\n", "nc-not-interpreted"),
       }) {
    check_family(family);
  }
}

TEST_CASE("a home is gone to through a point, and is a place of the machine") {
  const std::vector<Motion> motions = family_motions("G10 L2 P1 X10\nG0 Z7\nG28 X5\n", "linuxcnc");
  CHECK(kinds_of(motions) == "rrr");
  check_words(motions[1].to, {{5, 0, 7, 0, 0, 0}});
  check_words(motions[2].to, {{-10, 0, 7, 0, 0, 0}});
  check_words(motions[2].machine, {{0, 0, 7, 0, 0, 0}});
  CHECK(motions[2].in_machine_coordinates);
}

TEST_CASE("canned cycles: their words, levels and checks, and what they do at a hole") {
  for (const Family& family : {
           // from Z5: R 2, bottom -2, back to 5; twice
           in_place("cycles.cpp", "linuxcnc", "G98 G0 Z5 F100\nG91 G81 X10 R-3 Z-4 L2\n", "rrrfrrrfr",
                    {{20, 0, 5, 0, 0, 0}}, 0, "G0 Z5 F100\nG81 X1 R-5 Z-3\n", "nc-out-of-range"),
           in_place("cycle_words.cpp", "linuxcnc", "G99 G0 Z5 F100\nG81 R2 Z-3\nX10\n", "rrrfrrfr",
                    {{10, 0, 2, 0, 0, 0}}, 0, "G0 Z5 F100\nG81 X1 Z-3\n", "nc-word-missing"),
           // 3 deep from R 2 to -1, out, back to 0.254 above it, then to -4
           in_place("hole_motions.cpp", "linuxcnc", "G99 G0 Z2 F100\nG83 R2 Z-4 Q3\n", "rrfrrfr", {{0, 0, 2, 0, 0, 0}},
                    0, "G0 Z2 F100\nG83 R2 Z-4 Q0\n", "nc-out-of-range"),
           in_place("cycle_checks.cpp", "linuxcnc", "S100 M3\nG99 G0 Z2 F100\nG86 R2 Z-3 P0.5\n", "rrfdr",
                    {{0, 0, 2, 0, 0, 0}}, 0, "G99 G0 Z2 F100\nG86 R2 Z-3 P0.5\n", "nc-spindle-stands"),
           in_place("cycle_levels.cpp", "okuma",
                    "G15 H1\nG0 X1. Y2. Z40.\nM3 S1000\nG71 Z40.\nG81 X30. Z-5. R2. F100 M53\n", "rrrfr",
                    {{30, 2, 40, 0, 0, 0}}, 0, "G15 H1\nG0 X1. Y2. Z50.\nM3 S1000\nG81 X30. Z-5. R2. F100 M53\n",
                    "nc-not-interpreted"),
           in_place("cycle_calls.cpp", "siemens", "G0 X5 Z50\nF200\nCYCLE81(20,0,2,-8)\n", "rrfr",
                    {{5, 0, 20, 0, 0, 0}}, 0, "G0 X5 Z50\nF200\nCYCLE81(20,0,2)\n", "nc-not-interpreted"),
       }) {
    check_family(family);
  }
}

TEST_CASE("codes of the machine wait, call and go where only the machine knows") {
  for (const Family& family : {
           in_place("machine_codes.cpp", "linuxcnc", "G0 X1\nM8 M3 S100\nG4 P1.5\n", "rd", {{1, 0, 0, 0, 0, 0}}, 0,
                    "G4 P-1\n", "nc-negative"),
           in_place("macro_call.cpp", "fanuc", "O1\nG65 P9100 X30.\nM30\nO9100\nG0 X#24\nM99\n", "r",
                    {{30, 0, 0, 0, 0, 0}}, 0, "O1\nG65 X30.\n", "nc-word-missing"),
           // to the end of its travel: X as it says, Z as before
           in_place("machine_ways.cpp", "okuma", "G15 H1\nG0 X1. Z3.\nX2. Z9999\n", "rr", {{2, 0, 3, 0, 0, 0}}, 0,
                    "G15 H1\nG91 G0 Z9999\n", "nc-not-interpreted"),
       }) {
    check_family(family);
  }
}

TEST_CASE("an axis whose words have a sign goes home the way that its home says, in the turn in which it stands") {
  const auto end_of_c = [](const std::string& text, double home) {
    ProgramSettings settings = empty_tables();
    settings.rotary[2] = RotaryRule::sign;
    settings.variables = {{5166, home}};
    return motions_of("G90\nG0 X0 Y0 Z0 A0 B0 C0\nF100\n" + text + "G28\nM2\n", settings).back().to[Axis::C];
  };
  CHECK(end_of_c("", 0) == 0);  // as rs274 has it with WRAPPED_ROTARY
  CHECK(end_of_c("G1 C3\n", 0) == 360);
  CHECK(end_of_c("G0 C-10\n", 0) == 0);
  CHECK(end_of_c("G91 G1 C400\nG90\n", 0) == 720);
  CHECK(end_of_c("G91 G1 C-400\nG90\n", 0) == -360);
  CHECK(end_of_c("G1 C10\n", -20) == -340);
  CHECK(end_of_c("G91 G1 C363\nG90\n", -20) == 20);
  CHECK(end_of_c("G91 G1 C-380\nG90\n", -20) == -700);
  CHECK(end_of_c("G1 C3\n", 359) == 359);
  const auto refused = [](const std::string& text, double home) {
    ProgramSettings settings = empty_tables();
    settings.rotary[2] = RotaryRule::sign;
    settings.variables = {{5166, home}};
    return code_of("G90\nG0 X0 Y0 Z0 A0 B0 C0\n" + text + "M2\n", settings);
  };
  CHECK(refused("G28\n", 400) == "nc-not-interpreted");
  CHECK(refused("G10 L2 P1 C30\nG28\n", 20) == "nc-not-interpreted");
  CHECK(refused("G92 C5\nG28 C6\n", 0) == "nc-not-interpreted");
  CHECK(refused("G92 C5\nG28 X6\n", 0).empty());
}

TEST_CASE("an axis whose words have a sign is stored within one turn, and no offset sets it beyond") {
  ProgramSettings settings = empty_tables();
  settings.rotary = {RotaryRule::sign, RotaryRule::sign, RotaryRule::sign};
  const auto home_of = [&](const std::string& stores, Axis axis) {
    const std::string name = axis == Axis::C ? "6" : axis == Axis::A ? "4" : "5";
    return motions_of("G90\n" + stores + "G0 X0\nX#518" + name + "\nM2\n", settings).back().to[Axis::X];
  };
  CHECK(home_of("G53 G0 C-350\nG30.1\n", Axis::C) == Approx(350));  // as rs274 has it with WRAPPED_ROTARY
  CHECK(home_of("G0 A-10 B-20\nG30.1\n", Axis::A) == Approx(10));
  CHECK(home_of("G0 A-10 B-20\nG30.1\n", Axis::B) == Approx(20));
  CHECK(home_of("G0 C0\nG91 G1 C800 F100\nG90\nG30.1\n", Axis::C) == Approx(80));
  const std::string start = "G90 G54\nG0 X0 Y0 Z0 A0 B0 C0\n";
  for (const std::string line : {"G92 C-383", "G92 C360", "G52 C400", "G10 L20 P1 C365", "G92 X1 A-360"}) {
    INFO(line);
    CHECK(code_of(start + line + "\nM2\n", settings) == "nc-out-of-range");
  }
  for (const std::string line : {"G92 C-359", "G10 L20 P1 C10", "G10 L2 P1 C400", "G92 X1000"}) {
    INFO(line);
    CHECK(code_of(start + line + "\nM2\n", settings).empty());
  }
}

TEST_CASE("P beside G28 and G30 belongs to G64, as they have none on LinuxCNC") {
  for (const std::string line : {"G64 P0.05 G28 Z25", "G64 P0.7 G30 Z5", "G28 P0.5 G64"}) {
    INFO(line);
    CHECK(code_of("G90\nG0 X0 Y0 Z0 A0 B0 C0\n" + line + "\nM2\n", empty_tables()).empty());
  }
  CHECK(code_of("G90\nG0 X0\nG28 P0.5\nM2\n", empty_tables()) == "nc-word-unused");
}

TEST_CASE("behind a probe the help says what helps there") {
  const auto help = [](const std::string& text) {
    const auto refusal = refusal_of("G21 G90 G94\nG0 X0 Y0 Z20\n" + text + "M2\n", at_zero());
    REQUIRE(refusal);
    CHECK(refusal->code == "nc-position-unknown");
    return refusal->help;
  };
  for (const char* const text :
       {"G38.2 Z5 F50\nG10 L20 P1 Z0\n", "G38.3 X5 F50\nG92 X0\n", "G38.2 Z5 F50\n#10=#<_z>\n"}) {
    INFO(text);
    CHECK(help(text).find("program of its own") != std::string::npos);
    CHECK(help(text).find("--start") == std::string::npos);
  }
  ProgramSettings nowhere = at_zero();
  nowhere.start = {};
  CHECK(refusal_of("G92 X0\nM2\n", nowhere)->help.find("--start") != std::string::npos);
}
