#include "nc/rewrite/unrolled/written_moves.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/rewrite/last_step.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

using Texts = std::vector<std::string>;

// The last block of the program, written out.
Texts written_as(std::string_view text, std::string_view dialect_name = "linuxcnc") {
  ProgramSettings settings = at_zero();
  settings.as_with_empty_tables = true;
  const LastStep step(text, dialect_name, settings);
  WrittenMoves moves(dialect(dialect_name), 1);
  Texts texts;
  for (const Step* const made : moves.of(*step)) texts.emplace_back(made->block->text);
  return texts;
}

// The same under exact stops, where no others are needed.
Texts written(const std::string& text, std::string_view dialect_name = "linuxcnc") {
  return written_as(dialect_name == "linuxcnc" ? "G61\n" + text : text, dialect_name);
}

}  // namespace

TEST_CASE("a cycle of moves is written as them, each word where something moves") {
  CHECK(written("G99 G0 Z10\nN7 G81 X10 Y5 R2 Z-3 F100 (two)\n") ==
        Texts{"N7 F100 (two)", "G0 X10 Y5", "G0 Z2", "G1 Z-3", "G0 Z2"});
  CHECK(written("G98 G0 Z10 F100\nG81 X10 R2 Z-3\n") == Texts{"G0 X10", "G0 Z2", "G1 Z-3", "G0 Z10"});
}

TEST_CASE("the number of a block that holds nothing else goes to the first of its moves") {
  CHECK(written("G99 G0 Z10 F100\nN7 G81 X10 R2 Z-3\n") == Texts{"N7 G0 X10", "G0 Z2", "G1 Z-3", "G0 Z2"});
}

TEST_CASE("a dwell is written in the unit of the control") {
  CHECK(written("G99 G0 Z2 F100\nG82 R2 Z-3 P1.5\n") == Texts{"G1 Z-3", "G4 P1.5", "G0 Z2"});
  CHECK(written("G99 G0 Z2. F100.\nG82 R2. Z-3. P1500\n", "fanuc") == Texts{"G1 Z-3.", "G4 P1500", "G0 Z2."});
}

TEST_CASE("LinuxCNC drills in exact path mode: under G64 the tool comes to a stop behind each move written out") {
  const std::string drill = "G99 G0 Z10 F100\nG81 X10 R2 Z-3\n";
  const Texts stops{"G0 X10", "G4 P0", "G0 Z2", "G4 P0", "G1 Z-3", "G4 P0", "G0 Z2", "G4 P0"};
  for (const std::string mode : {"", "G64\n", "G64 P0.05\n", "G61\nG64 P0.05 Q0.01\n"}) {
    INFO(mode);
    CHECK(written_as(mode + drill) == stops);
  }
  for (const std::string mode : {"G61\n", "G61.1\n"}) CHECK(written_as(mode + drill).size() == 4);
  CHECK(written_as("G99 G0 Z2 F100\nG82 R2 Z-3 P1.5\n") == Texts{"G1 Z-3", "G4 P1.5", "G0 Z2", "G4 P0"});
  CHECK(written_as("G99 G0 Z10 F100 S100 M3\nG84 X10 Y5 R2 Z-3\n") ==
        Texts{"G0 X10 Y5", "G4 P0", "G84 X10 Y5 Z-3 R2 P0"});
  CHECK(written_as("G99 G0 Z2. F100.\nG81 R2. Z-3.\n", "fanuc") == Texts{"G1 Z-3.", "G0 Z2."});
}

TEST_CASE("increments are written as increments, in the unit of the program") {
  CHECK(written("G99 G0 Z10 F100\nG91 G81 X10 R-8 Z-5 L2\n") ==
        Texts{"G91", "G0 X10", "G0 Z-8", "G1 Z-5", "G0 Z5", "G0 X10", "G1 Z-5", "G0 Z5"});
  CHECK(written("G20 G99 G0 Z1 F100\nG81 X.5 R.25 Z-.125\n") == Texts{"G0 X0.5", "G0 Z0.25", "G1 Z-0.125", "G0 Z0.25"});
}

TEST_CASE("a cycle that works the spindle stays one a hole, every word of it stated") {
  CHECK(written("G99 G0 Z10 F100 S100 M3\nG84 X10 Y5 R2 Z-3\n") == Texts{"G0 X10 Y5", "G84 X10 Y5 Z-3 R2 P0"});
  CHECK(written("G99 G0 Z10 F100 S100 M3\nG91 G84 X10 R-8 Z-5 L2\n") ==
        Texts{"G91", "G0 X10", "G90 G84 X10 Y0 Z-3 R2 P0", "G91", "G0 X10", "G90 G84 X20 Y0 Z-3 R2 P0", "G91"});
}

TEST_CASE("on a Fanuc the block of one hole stays where it stands, with its other words") {
  CHECK(written("G99 G0 Z10. F100. S100 M3\nG84 X10. R2. Z-3. P250 (tap)\n", "fanuc") ==
        Texts{"G84 X10. R2. Z-3. P250 Y0. (tap)"});
}

TEST_CASE("words that act after the motion stand after it; what would act before the hole is refused") {
  CHECK(written("G99 G0 Z2 F100\nG81 R2 Z-3 M0\n") == Texts{"G1 Z-3", "G0 Z2", "M0"});
  const auto beside = [&] { written("G99 G0 Z2. F100.\nG81 R2. Z-3. M0\n", "fanuc"); };
  const Diagnostic refused = testing::refusal_of(beside);
  CHECK(refused.code == "emit-m-code");
  CHECK(refused.place.line == 2);
  CHECK(refused.place.column == 14);
}

TEST_CASE("a hole is one where nothing counts it and its words are positions") {
  const auto one = [](std::string_view text) { return WrittenMoves::is_one_hole(*LastStep(text)); };
  CHECK(one("G0 Z10 F100\nG81 X10 R2 Z-3\n"));
  CHECK_FALSE(one("G0 Z10 F100\nG81 X10 R2 Z-3 L1\n"));
  CHECK_FALSE(one("G0 Z10 F100\nG91 G81 X10 R-8 Z-3\n"));
  CHECK_FALSE(one("G0 Z10 F100\nG4 P1 X5\n"));
}
