// What a program makes the machine do, one move at a time: the hand-over from nc to path.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/axes.hpp"
#include "nc/language/feed_rule.hpp"

namespace plumbline::nc {

enum class MotionKind : std::uint8_t { rapid, feed, arc, probe, dwell };
enum class FeedMode : std::uint8_t { inverse_time, per_minute, per_revolution };  // G93, G94, G95
enum class Plane : std::uint8_t { xy, zx, yz };                                   // G17, G18, G19

/// The linear axes of a plane: first and second turn into each other counter-clockwise, third is normal to both.
struct PlaneAxes {
  Axis first, second, third;
};
constexpr PlaneAxes axes_of(Plane plane) {
  switch (plane) {
    case Plane::zx:
      return {Axis::Z, Axis::X, Axis::Y};
    case Plane::yz:
      return {Axis::Y, Axis::Z, Axis::X};
    case Plane::xy:
      break;
  }
  return {Axis::X, Axis::Y, Axis::Z};
}

/// A circle or helix about an axis normal to the plane.
struct Arc {
  Plane plane = Plane::xy;
  std::array<double, 3> centre_mm{};  // x, y, z in the active work system; along the normal: the start's
  int turns = 0;                      // full turns begun: 1 = up to one counter-clockwise; negative: clockwise
};

/// One move. Positions are in the active work system (what the words of the program mean), in mm and deg.
struct Motion {
  MotionKind kind = MotionKind::rapid;
  FeedMode feed_mode = FeedMode::per_minute;
  bool in_machine_coordinates = false;  // G53, and the moves of G28 and G30: never compensated
  std::size_t line = 0;
  AxisWords from, to;
  AxisWords machine;       // the control's display at `to`: all offsets, rotation and the tool length in it
  AxisSet known_before;    // axes whose `from` is known
  AxisSet known_after;     // axes whose `to` is known
  double feed = 0;         // per_minute: mm/min, or deg/min for a purely rotary move; inverse_time: 1/min;
                           // per_revolution: mm/rev. 0: no feed in force
  double mm_per_unit = 1;  // the program's length unit at this move: 25.4 under G20
  double dwell_s = 0;      // dwell only
  double dwell_turns = 0;  // of a cycle: what it waits for, in turns of the spindle; 0: seconds
  FeedRule feed_rule = FeedRule::unknown;  // which length its feed is the speed along
  bool feed_along_circle = false;          // of an arc: its circle alone, whatever else moves with it
  Arc arc;                                 // arc only
  bool unknown_strokes = false;            // a cycle's, in strokes of its own making: how long it takes is not known
  bool goes_on = false;                    // a piece of a spline, and not its last
};

}  // namespace plumbline::nc
