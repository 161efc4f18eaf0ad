#include "nc/rewrite/unrolled/restored_modes.hpp"

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::nc;

namespace {

using Lines = std::vector<std::string>;

// The modes before and after the end of a subprogram, and what is written of their difference.
struct Restored {
  Modal was, is;
  Frame frame;
  std::optional<bool> g92;
  OutputState control;
  Spelling spelling{.spaced = true};

  Lines lines(bool other_length = false) {
    Step step;
    step.before = &was;
    step.after = &is;
    step.frame = &frame;
    step.g92_restored = g92;
    Lines written;
    write_restored_modes(step, other_length, CodeWriter(dialect("linuxcnc")), spelling, control,
                         [&](const std::string& line) {
                           if (!line.empty()) written.push_back(line);
                         });
    return written;
  }
};

}  // namespace

TEST_CASE("modes that are the same are not written") {
  Restored same;
  CHECK(same.lines().empty());
  same.was.tool_in_spindle = 3;
  same.is.tool_in_spindle = 4;
  CHECK(same.lines().empty());
}

TEST_CASE("what differs comes back in one line, spelt like the program") {
  Restored modes;
  modes.is.inches = true;
  modes.is.plane = Plane::yz;
  modes.is.incremental = true;
  modes.is.arc_centre_absolute = true;
  modes.is.retract_to_r = false;
  modes.is.work_system = 7;
  CHECK(modes.lines() == Lines{"G20 G19 G91 G90.1 G98 G59.1"});
  modes.spelling = {.lower_case = true};
  CHECK(modes.lines() == Lines{"g20g19g91g90.1g98g59.1"});
  std::swap(modes.was, modes.is);
  CHECK(modes.lines() == Lines{"g21g17g90g91.1g99g54"});
}

TEST_CASE("path control comes back with its tolerances") {
  Restored modes;
  modes.is.path_control = PathControl::exact_stop;
  CHECK(modes.lines() == Lines{"G61.1"});
  modes.is.path_control = PathControl::continuous;
  modes.is.switches.path_tolerance = 0.05;
  modes.is.switches.naive_tolerance = 0.01;
  CHECK(modes.lines() == Lines{"G64 P0.05 Q0"});
  modes.was.path_control = modes.is.path_control = PathControl::exact_path;  // in which tolerances do not count
  CHECK(modes.lines().empty());
}

TEST_CASE("F comes after its mode, which drops it, and in the unit that is back") {
  Restored mode;
  mode.is.feed_mode = FeedMode::per_revolution;
  mode.is.feed = 0.2;
  mode.control.set_feed(0.2);
  CHECK(mode.lines() == Lines{"G95", "F0.2"});
  CHECK(mode.control.feed == 0.2);
  CHECK(mode.control.feed_mode == FeedMode::per_revolution);
  CHECK(mode.lines().empty());
  Restored unit;
  unit.is.inches = true;
  unit.is.feed = 20;
  unit.control.set_feed(508);  // mm/min
  CHECK(unit.lines() == Lines{"G20"});
  CHECK(unit.control.feed == 20);
  Restored timed;
  timed.is.feed_mode = FeedMode::inverse_time;
  timed.is.feed = 5;
  CHECK(timed.lines() == Lines{"G93"});
}

TEST_CASE("what is switched on comes back on, and what is not goes off first") {
  Restored modes;
  modes.is.switches.speed = 1200;
  modes.is.switches.spindle = kClockwise;
  modes.was.switches.mist = true;
  modes.is.switches.flood = true;
  modes.is.switches.feed_override = false;
  modes.is.switches.adaptive_feed = true;
  CHECK(modes.lines() == Lines{"S1200 M3", "M9", "M8", "M50 P0", "M52 P1"});
  std::swap(modes.was, modes.is);
  CHECK(modes.lines() == Lines{"S0 M5", "M9", "M7", "M50 P1", "M52 P0"});
  Restored more;
  more.was.switches.mist = true;
  more.is.switches.mist = more.is.switches.flood = true;
  CHECK(more.lines() == Lines{"M8"});
}

TEST_CASE("the length of the tool comes back by its number, by words, or not at all") {
  Restored length;
  CHECK(length.lines().empty());
  CHECK(length.lines(true) == Lines{"G49"});
  length.frame.tool[Axis::Z] = 50.8;
  length.is.tool_of_offset = 3;
  CHECK(length.lines(true) == Lines{"G43 H3"});
  length.is.tool_of_offset = -1;
  CHECK(length.lines(true) == Lines{"G43.1 X0 Y0 Z50.8 A0 B0 C0"});
  length.was.inches = length.is.inches = true;
  CHECK(length.lines(true) == Lines{"G43.1 X0 Y0 Z2 A0 B0 C0"});
}

TEST_CASE("the shift of G92 comes back last") {
  Restored shift;
  shift.is.inches = true;
  shift.g92 = true;
  CHECK(shift.lines() == Lines{"G20", "G92.3"});
  shift.g92 = false;
  CHECK(shift.lines() == Lines{"G20", "G92.2"});
}
