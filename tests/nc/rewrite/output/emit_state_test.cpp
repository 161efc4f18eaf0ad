#include "nc/rewrite/output/emit_state.hpp"

#include <catch2/catch.hpp>

#include "nc/rewrite/last_step.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

OutputState off_by(double x, double y, double z) {
  OutputState state;
  state.shift = {{x, y, z, 0, 0, 0}};
  return state;
}

void follow(OutputState& state, const LastStep& step, std::string_view dialect_name = "linuxcnc") {
  state.follow(*step, CodeWriter(dialect(dialect_name)).codes_of(*step->block));
}

}  // namespace

TEST_CASE("an absolute word puts its axis where the original stands, an increment leaves it off") {
  OutputState state = off_by(0.01, 0.02, 0.03);
  follow(state, LastStep("G1 X1 Z2 F100\n"));
  CHECK(state.shift == AxisWords{{0, 0.02, 0, 0, 0, 0}});
  CHECK(state.motion == MotionMode::feed);
  CHECK(state.feed == 100);
  follow(state, LastStep("G91 G0 Y1\n"));
  CHECK(state.shift[Axis::Y] == 0.02);
  OutputState by_word = off_by(0.01, 0.02, 0);
  follow(by_word, LastStep("G1 X=IC(5) Y2 F100\n", "siemens", empty_tables()), "siemens");
  CHECK(by_word.shift == AxisWords{{0.01, 0, 0, 0, 0, 0}});
}

TEST_CASE("what does not move leaves the control where it is, a move of the machine does not") {
  OutputState state = off_by(0.01, 0.02, 0.03);
  follow(state, LastStep("M8\n"));
  CHECK(state.shift == AxisWords{{0.01, 0.02, 0.03, 0, 0, 0}});
  follow(state, LastStep("G53 G0 Z5\n"));
  CHECK(state.shift == AxisWords{{0.01, 0.02, 0, 0, 0, 0}});
}

TEST_CASE("a shift is the same place in the words of a turned system") {
  ProgramSettings turned = at_zero();
  turned.work_offsets[0] = WorkOffset{{}, 90};
  const LastStep step("G0 X1 Y1\n", "linuxcnc", turned);
  OutputState state;
  state.set_work_shift(*step->frame, {{0.5, 0, 0.25, 0, 0, 0}});
  CHECK(state.shift[Axis::X] == Approx(0).margin(1e-15));
  CHECK(state.shift[Axis::Y] == Approx(0.5));
  CHECK(state.shift[Axis::Z] == 0.25);
  CHECK(state.work_shift(*step->frame)[Axis::X] == Approx(0.5));
  follow(state, LastStep("G0 X1\n", "linuxcnc", turned));
  CHECK(state.shift[Axis::Y] == Approx(0).margin(1e-15));  // X of the system is Y of W
  CHECK(state.shift[Axis::Z] == 0.25);
}

TEST_CASE("F keeps its speed over a change of units, as degrees a minute its number") {
  OutputState state;
  state.set_feed(254);
  const LastStep step("G20\n");
  follow(state, step);
  CHECK(state.feed == 0);  // the program has none in force
  state.set_feed(254);
  state.change_unit(*step->before, *step->after);
  CHECK(state.feed == Approx(10));
  CHECK(state.feed_rotary == 254);
  state.change_unit(*step->after, *step->before);
  CHECK(state.feed == Approx(254));
  state.change_unit(*step->before, *step->before);
  CHECK(state.feed == Approx(254));
}

TEST_CASE("F goes with its feed mode") {
  OutputState state;
  state.set_feed(80);
  const LastStep step("G94 F100\n");
  BlockCodes codes = CodeWriter(dialect("linuxcnc")).codes_of(*step->block);
  codes.feed = nullptr;  // as where a dwell takes the F
  state.follow(*step, codes);
  CHECK(state.feed == 80);
  follow(state, LastStep("G93\n"));
  CHECK(state.feed == 0);
  CHECK(state.feed_rotary == 0);
  CHECK(state.feed_mode == FeedMode::inverse_time);
}

TEST_CASE("the modes of the original are taken over as they are") {
  Modal modal;
  modal.motion = MotionMode::arc_ccw;
  modal.feed_mode = FeedMode::per_revolution;
  modal.feed = 0.2;
  modal.feed_rotary = 0.3;
  OutputState state = off_by(0.01, 0, 0);
  state.adopt(modal);
  CHECK(state.motion == MotionMode::arc_ccw);
  CHECK(state.feed_mode == FeedMode::per_revolution);
  CHECK(state.feed == 0.2);
  CHECK(state.feed_rotary == 0.3);
  CHECK(state.shift[Axis::X] == 0.01);
}
