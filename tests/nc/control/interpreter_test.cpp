// Also actions.cpp, motion_modes.cpp and saved_modes.cpp, which it calls: the programs beside this test run through
// them. What is known, what is lost, what needs to be given: the part of the interpreter that no other control can
// vouch for.
#include "nc/control/interpreter.hpp"

#include <functional>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

// What a step says, kept beyond the next one.
struct Kept {
  AxisSet known, known_after;
  AxisWords position;
  BlockRole role;
  Modal after;
  BlockDelete block_delete;
  ToolChange tool_change;
  bool loses_position;
  std::vector<Motion> motions;
};

std::vector<Kept> run(std::string_view text, const ProgramSettings& settings) {
  const ProgramFile program(text);
  const InputFile file(program.path());
  Program steps(file, dialect("linuxcnc"), settings);
  std::vector<Kept> kept;
  while (const Step* s = steps.next()) {
    kept.push_back({s->known,
                    {},
                    s->position,
                    s->role,
                    *s->after,
                    s->block_delete,
                    s->tool_change,
                    s->loses_position,
                    {s->motions.begin(), s->motions.end()}});
  }
  return kept;
}

// Offsets given, nothing known of where the axes stand.
ProgramSettings unknown_start() {
  ProgramSettings settings;
  settings.work_offsets[0] = WorkOffset{};
  return settings;
}

}  // namespace

TEST_CASE("an absolute word makes its axis known, an increment does not") {
  const auto steps = run("G0 X1 Y2\nG91 G0 Z1\nG90 Z3\n", unknown_start());
  CHECK(steps[0].known == AxisSet{Axis::X, Axis::Y});
  CHECK(steps[0].motions[0].known_before.empty());
  CHECK(steps[0].motions[0].known_after == AxisSet{Axis::X, Axis::Y});
  CHECK(steps[1].known == AxisSet{Axis::X, Axis::Y});
  CHECK(steps[2].known == AxisSet{Axis::X, Axis::Y, Axis::Z});
}

TEST_CASE("stops, tool changes, user codes and homes lose the position, unless it is kept") {
  ProgramSettings settings = at_zero();
  settings.passed_m_codes = {100};
  for (const char* code : {"M60", "T1 M6", "M100", "G28", "G30"}) {
    INFO(code);
    const auto steps = run(std::string(code) + "\n", settings);
    CHECK(steps[0].known.empty());
    CHECK(steps[0].loses_position);
  }
  CHECK(run("G28 Z5\n", settings)[0].known == AxisSet::all() - AxisSet{Axis::Z});
  settings.keeps_position = {60, 6, 100};
  for (const char* code : {"M0", "M1", "M60", "T1 M6", "M100", "M3", "M2", "G4 P1", "M61 Q2"}) {
    INFO(code);
    const auto steps = run(std::string(code) + "\n", settings);
    CHECK(steps[0].known == AxisSet::all());
    CHECK_FALSE(steps[0].loses_position);
  }
}

TEST_CASE("a stored or given home is a known position") {
  ProgramSettings settings = at_zero();
  const auto stored = run("G0 X5 Y6\nG28.1\nG0 X0\nG28 X1\n", settings);
  CHECK(stored[1].role == BlockRole::stores_position);
  CHECK(stored[3].role == BlockRole::machine_move);
  CHECK(stored[3].known == AxisSet::all());
  CHECK(stored[3].position[Axis::X] == 5);
  settings.variables = {{5181, 12.5}};
  const auto given = run("G30 X1\n", settings);
  CHECK(given[0].known == AxisSet::all());
  CHECK(given[0].position[Axis::X] == 12.5);
}

TEST_CASE("G53 makes its axes known, in a turned work system X and Y only together") {
  const auto straight = run("G53 G0 Z5\n", unknown_start());
  CHECK(straight[0].role == BlockRole::machine_move);
  CHECK(straight[0].motions[0].in_machine_coordinates);
  CHECK(straight[0].known == AxisSet{Axis::Z});
  ProgramSettings turned = unknown_start();
  turned.work_offsets[0] = WorkOffset{{}, 30};
  CHECK(run("G53 G0 X5\n", turned)[0].known.empty());
  CHECK(run("G53 G0 X5 Y1\n", turned)[0].known == AxisSet{Axis::X, Axis::Y});
}

TEST_CASE("a change of work systems keeps what is known, and needs both X and Y where one is turned") {
  ProgramSettings settings = unknown_start();
  settings.work_offsets[1] = WorkOffset{{{10, 0, 0, 0, 0, 0}}, 0};
  settings.work_offsets[2] = WorkOffset{{}, 45};
  const auto steps = run("G0 X1 Z2\nG55\nG56\n", settings);
  CHECK(steps[1].known == AxisSet{Axis::X, Axis::Z});
  CHECK(steps[1].position[Axis::X] == -9);
  CHECK(steps[2].known == AxisSet{Axis::Z});
}

TEST_CASE("a work system needs its offset when something moves under it, and not before") {
  CHECK(code_of("G55\nG53 G0 X1\nG54 G0 X1\n", at_zero()).empty());
  CHECK(code_of("G55 G0 X1\n", at_zero()) == "nc-work-offset-unknown");
  CHECK(code_of("G55 G0 X1\n", empty_tables()).empty());
  CHECK(code_of("G10 L2 P2 X1 Y2 Z3 A0 B0 C0\nG55 G0 X1\n", at_zero()).empty());
  CHECK(code_of("G10 L2 P2 X1 Y2 Z3\nG55 G0 X1\n", at_zero()) == "nc-work-offset-unknown");
  CHECK(code_of("G10 L20 P2 X0 Y0 Z0 A0 B0 C0\nG55 G0 X1\n", at_zero()).empty());
}

TEST_CASE("codes that read the position say so") {
  CHECK(run("G92 X5\n", at_zero())[0].role == BlockRole::sets_offset);
  CHECK(run("G10 L20 P1 X5\n", at_zero())[0].role == BlockRole::sets_offset);
  CHECK(run("G10 L2 P1 X5\n", at_zero())[0].role == BlockRole::plain);
  CHECK(code_of("G92 X5\n", unknown_start()) == "nc-position-unknown");
  CHECK(code_of("G0 Y1\nG92 Y5\n", unknown_start()).empty());
}

TEST_CASE("block delete is a choice wherever it matters") {
  ProgramSettings settings = at_zero();
  CHECK(code_of("/M8\n/(comment)\n/\n/ N5 M9\n", settings).empty());
  for (const char* block : {"/G0 X1\n", "/G91\n", "/F5\n", "/#1=3\n", "/M3\n", "/T1\n", "/M8 G4 P1\n"}) {
    INFO(block);
    CHECK(code_of(block, settings) == "nc-block-delete");
  }
  settings.block_delete = true;
  const auto on = run("/G0 X1\n/M8\n", settings);
  CHECK(on[0].block_delete == BlockDelete::left_out);
  CHECK(on[0].motions.empty());
  CHECK(on[1].block_delete == BlockDelete::left_out);
  settings.block_delete = false;
  const auto off = run("/G0 X1\n/M8\n", settings);
  CHECK(off[0].block_delete == BlockDelete::executed);
  CHECK(off[0].motions.size() == 1);
  CHECK(off[1].block_delete == BlockDelete::none);
}

TEST_CASE("values that only the machine knows may turn the spindle and no more") {
  CHECK(code_of("M66 P0 L0\n#1=#5399\nS#1 M3\n", at_zero()).empty());
  for (const char* block : {"G0 X#1\n", "G4 P#1\n", "G1 X1 F#1\n", "T#1\n", "G10 L2 P1 X#1\n"}) {
    INFO(block);
    CHECK(code_of(std::string("M66 P0 L0\n#1=[#5399+1]\n") + block, at_zero()) == "nc-value-unknown");
  }
  CHECK(code_of("M66 P0 L0\n#5399=2\nG0 X#5399\n", at_zero()).empty());
}

TEST_CASE("a name that another program may have made is named, and so are the axes that a cycle misses") {
  const auto message = [](const char* text) {
    const auto refusal = refusal_of(text, at_zero());
    return refusal ? refusal->message : "";
  };
  CHECK(message("o1 if [1 + EXISTS[#<_depth>] GT 1]\no1 endif\n").find("#<_depth> exists") != std::string::npos);
  CHECK(message("G0 X[EXISTS[#<_depth>]]\n").find("#<_depth> exists") != std::string::npos);
  CHECK(message("M66 P0 L0\no1 if [#5399]\no1 endif\n").find("exists") == std::string::npos);
  CHECK(message("T1 M6\nG81 X1 Y1 Z-1 R1 F100\n").find("where Z is") != std::string::npos);
  CHECK(message("T1 M6\nG0 Z5\nG91 G81 X1 Y1 Z-1 R1 F100\n").find("where X, Y is") != std::string::npos);
}

TEST_CASE("variables and positions are read where somebody gave them") {
  ProgramSettings settings = at_zero();
  settings.variables = {{31, 4.0}};
  CHECK(motions_of("G0 X#31\n", settings)[0].to[Axis::X] == 4);
  CHECK(code_of("G0 X#32\n", settings) == "nc-parameter-unset");
  CHECK(motions_of("G0 X5\nG0 Y#5420\n", settings)[1].to[Axis::Y] == 5);
}

TEST_CASE("tools take their length from the table and say whose it is") {
  ProgramSettings settings = at_zero();
  settings.tools = ToolTable({Tool{3, 100, {}, {}, {}}});
  const auto steps = run("T3 M6\nG43\nG0 X0 Y0 Z0\nG49\nG43 H3\nM61 Q5\nG43.1 Z7\n", settings);
  CHECK(steps[0].tool_change == ToolChange::before_motion);
  CHECK(steps[0].after.tool_in_spindle == 3);
  CHECK(steps[1].after.tool_of_offset == 3);
  CHECK(steps[2].motions[0].machine[Axis::Z] == 100);
  CHECK(steps[2].motions[0].to[Axis::Z] == 0);
  CHECK(steps[3].after.tool_of_offset == -1);
  CHECK(steps[4].after.tool_of_offset == 3);
  CHECK(steps[5].after.tool_in_spindle == 5);
  CHECK(steps[6].after.tool_of_offset == -1);
  CHECK(code_of("G43 H4\n", settings) == "nc-tool-unknown");
  settings.tool_in_spindle = 3;
  CHECK(code_of("G43\n", settings).empty());
}

TEST_CASE("feeds are in mm, deg or one over minutes") {
  const auto motions =
      motions_of("G21 G1 X10 F100\nA10\nX20 A20\nG20 X2\nF10 X3\nA5\nG93 X4 F2\nG0 X0\nG94 F3 G1 A0\nG21 X5\n");
  REQUIRE(motions.size() == 10);
  CHECK(motions[0].feed == 100);
  CHECK(motions[1].feed == 100);  // deg/min
  CHECK(motions[2].feed == 100);  // X Y Z move: mm/min
  CHECK(motions[3].feed == 100);  // the F of before, still mm/min
  CHECK(motions[4].feed == Approx(254));
  CHECK(motions[5].feed == 10);  // deg/min whatever the unit
  CHECK(motions[6].feed == 2);
  CHECK(motions[6].feed_mode == FeedMode::inverse_time);
  CHECK(motions[7].feed == 0);
  CHECK(motions[8].feed == 3);
  CHECK(motions[9].feed == Approx(3 * 25.4));
}

TEST_CASE("user codes go through when they are passed, and any in a trace") {
  CHECK(code_of("M428\n", at_zero()) == "nc-user-code");
  CHECK(code_of("M428\n", empty_tables()).empty());
  CHECK(code_of("M100 P1 Q2\n", empty_tables()).empty());
  CHECK(code_of("M44\n", empty_tables()) == "nc-unknown-code");
  ProgramSettings settings = at_zero();
  settings.passed_m_codes = {44, 70};
  CHECK(code_of("M44\nM70\n", settings).empty());
}

TEST_CASE("an arc must start where its plane is known") {
  CHECK(code_of("G0 X0\nG2 X10 I5 F100\n", unknown_start()) == "nc-position-unknown");
  CHECK(code_of("G0 X0 Y0\nG2 X10 I5 F100\n", unknown_start()).empty());
}

TEST_CASE("a rotation changed under a shift leaves X and Y unknown: the control errs about them") {
  CHECK(run("G92 X5\nG10 L2 P1 R30\n", at_zero())[1].known == AxisSet::all() - AxisSet{Axis::X, Axis::Y});
  CHECK(run("G92 Z5\nG10 L2 P1 R30\n", at_zero())[1].known == AxisSet::all());
}
