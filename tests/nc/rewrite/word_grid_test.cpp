#include "nc/rewrite/word_grid.hpp"

#include <array>
#include <optional>
#include <utility>

#include <catch2/catch.hpp>

#include "nc/rewrite/last_step.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

struct Words {
  explicit Words(std::string_view name = "linuxcnc", EmitSettings how = {})
      : settings(std::move(how)), grid(dialect(name), settings) {}
  EmitSettings settings;
  WordGrid grid;
};

AxisWords only(Axis axis, double value) {
  AxisWords words;
  words[axis] = value;
  return words;
}

// True if the block of `step` stays where its one point is shifted and the control stands off.
bool stays(const LastStep& step, const AxisWords& shift, const AxisWords& off = {}) {
  OutputState control;
  control.shift = off;
  const std::array points{CorrectedPoint{step->motions.front().to, shift}};
  return Words().grid.stays(*step, points, AxisSet::all(), control);
}

ProgramSettings endless(RotaryRule rule) {
  ProgramSettings settings = at_zero();
  settings.rotary = {rule, rule, rule};
  return settings;
}

}  // namespace

TEST_CASE("an axis has the decimals that are asked for, or those of its word, in the unit of the program") {
  const Words words;
  const LastStep step("G0 X1.123456 Y1\n");
  CHECK(words.grid.grids(*step)[index(Axis::X)]->digits == 6);
  CHECK(words.grid.grids(*step)[index(Axis::X)]->quantum == Approx(1e-6));
  CHECK(words.grid.grids(*step)[index(Axis::Y)]->digits == 4);
  CHECK(words.grid.grids(*step)[index(Axis::Z)]->digits == 4);
  CHECK(words.grid.grids(*step)[index(Axis::A)]->digits == 5);
  const LastStep inches("G20 G0 X1\n");
  CHECK(words.grid.grids(*inches)[index(Axis::X)]->digits == 6);
  CHECK(words.grid.grids(*inches)[index(Axis::X)]->per_unit == 25.4);
  CHECK(words.grid.grids(*inches)[index(Axis::A)]->per_unit == 1);
}

TEST_CASE("a control that keeps its increments bounds the decimals, and so does --increment") {
  const LastStep step("G0 X1.12345 Y0.\n", "fanuc");
  CHECK(Words("fanuc").grid.grids(*step)[index(Axis::X)]->digits == 3);
  CHECK(Words("fanuc").grid.rounded(*step, Axis::X, 1.23456) == 1.235);
  EmitSettings coarse;
  coarse.increment_mm = 0.005;
  const Words words("linuxcnc", coarse);
  const LastStep metric("G0 X1\n");
  CHECK(words.grid.rounded(*metric, Axis::X, 1.0124) == Approx(1.01));
  CHECK(words.grid.rounded(*metric, Axis::X, 1.0126) == Approx(1.015));
}

TEST_CASE("a shift is none below half of the last decimal, or where the axis may not be written") {
  const Words words;
  const LastStep step("G0 X1 A1\n");
  CHECK(words.grid.rounds_to_zero(*step, only(Axis::X, 0.00004), AxisSet::all()));
  CHECK_FALSE(words.grid.rounds_to_zero(*step, only(Axis::X, -0.00006), AxisSet::all()));
  CHECK(words.grid.rounds_to_zero(*step, only(Axis::X, -0.00006), AxisSet{Axis::Y}));
  CHECK_FALSE(words.grid.rounds_to_zero(*step, only(Axis::A, 0.00001), AxisSet::all()));
  const LastStep inches("G20 G0 X1\n");
  CHECK(words.grid.rounds_to_zero(*inches, only(Axis::X, 12e-6), AxisSet::all()));  // half of a micro-inch is 12.7 nm
  CHECK_FALSE(words.grid.rounds_to_zero(*inches, only(Axis::X, 13e-6), AxisSet::all()));
}

TEST_CASE("a block stays where nothing of it would be written otherwise") {
  const LastStep step("G1 X10 F100\n");
  CHECK(stays(step, {}));
  CHECK(stays(step, only(Axis::Z, 0.00004)));
  CHECK_FALSE(stays(step, only(Axis::Z, 0.00006)));
  CHECK(stays(step, {}, only(Axis::X, 0.005)));        // it says where X goes
  CHECK_FALSE(stays(step, {}, only(Axis::X, 0.02)));   // but 0.2 % of its way would keep no time
  CHECK_FALSE(stays(step, {}, only(Axis::Y, 0.005)));  // it does not say where Y goes
  CHECK_FALSE(stays(LastStep("G91 G1 X10 F100\n"), {}, only(Axis::X, 0.005)));
  CHECK(stays(LastStep("G0 X10\n"), {}, only(Axis::X, 0.02)));
}

TEST_CASE("an arc stays only where it starts almost on the spot") {
  const LastStep arc("G2 X10 I5 F100\n");
  CHECK(stays(arc, {}, only(Axis::X, 0.9e-7)));
  CHECK_FALSE(stays(arc, {}, only(Axis::X, 1.1e-7)));
}

TEST_CASE("the word of an axis without end leads on from where the axis stands") {
  const Words words;
  const LastStep sign("G0 A10\n", "linuxcnc", endless(RotaryRule::sign));
  CHECK(words.grid.endless_word(*sign, Axis::A, 370, 350, true) == Approx(10));
  CHECK(words.grid.endless_word(*sign, Axis::A, 340, 350, true) == Approx(-340));
  const LastStep shortest("G0 A10\n", "linuxcnc", endless(RotaryRule::shortest));
  CHECK(words.grid.endless_word(*shortest, Axis::A, -10, 5, true) == Approx(350));
  const auto refusal = [&](double to, double from) {
    return testing::refusal_of([&] { words.grid.endless_word(*shortest, Axis::A, to, from, true); }).code;
  };
  CHECK(refusal(300, 5) == "emit-rotary-word");  // the shorter way leads to -60
  CHECK(refusal(-10, 5).empty());
}

TEST_CASE("where an axis without end stands may be unknown: then its place is within the first turn") {
  const Words words;
  const LastStep step("G0 A10\n", "linuxcnc", endless(RotaryRule::shortest));
  CHECK(words.grid.endless_word(*step, Axis::A, 10.5, 0, false) == Approx(10.5));
  CHECK(testing::refusal_of([&] { words.grid.endless_word(*step, Axis::A, 370, 0, false); }).code ==
        "emit-rotary-word");
  const LastStep sign("G0 A10\n", "linuxcnc", endless(RotaryRule::sign));
  CHECK(words.grid.endless_word(*sign, Axis::A, 9.5, 0, false) == Approx(9.5));
}

TEST_CASE("an axis that may still stand where it was left is not turned all the way round") {
  const Words words;
  const LastStep step("G0 A10\n", "linuxcnc", endless(RotaryRule::sign));  // it stood at 0 before
  CHECK(words.grid.endless_word(*step, Axis::A, 10.1, 0.2, false) == Approx(10.1));
  CHECK(testing::refusal_of([&] { words.grid.endless_word(*step, Axis::A, 10.1, 10.2, false); }).code ==
        "emit-rotary-word");
}

TEST_CASE("numbers that no word holds are refused") {
  const LastStep step("G0 X1.\n", "fanuc");
  const auto code_of_work = [](const auto& work) { return testing::refusal_of(work).code; };
  CHECK(code_of_work([&] { WordGrid::check_word(*step, 999999.9); }).empty());
  CHECK(code_of_work([&] { WordGrid::check_word(*step, -1e6); }) == "emit-out-of-range");
  const Words fanuc("fanuc");  // eight digits
  CHECK(code_of_work([&] { fanuc.grid.check_digits(*step, 99999.999, 3); }).empty());
  CHECK(code_of_work([&] { fanuc.grid.check_digits(*step, 100000, 3); }) == "emit-out-of-range");
  CHECK(code_of_work([&] { Words().grid.check_digits(*step, 100000, 3); }).empty());
  CHECK(code_of_work([&] { Words().grid.offset_word(*step, Axis::X, 2e6); }) == "emit-out-of-range");
}

TEST_CASE("a word that says where an axis stands keeps every digit that the control keeps") {
  const LastStep step("G0 X1.\n", "fanuc");
  CHECK(Words("fanuc").grid.offset_word(*step, Axis::X, 1.23456) == 1.235);
  CHECK(Words().grid.offset_word(*LastStep("G0 X1\n"), Axis::X, 1.23456789) == 1.23456789);
}
