// The modal state of a control: what a block inherits from the blocks before it.
#pragma once

#include <array>
#include <cstdint>

#include "base/axes.hpp"
#include "base/units.hpp"
#include "nc/control/state/motion.hpp"
#include "nc/language/rotary.hpp"

namespace plumbline::nc {

// G80, G0, G1, G2, G3, G73..G89; special: G5.2, G33, G38.2
enum class MotionMode : std::uint8_t { none, rapid, feed, arc_cw, arc_ccw, cycle, special };
enum class PathControl : std::uint8_t { exact_path, exact_stop, continuous };  // G61, G61.1, G64

// What the spindle does, as the rows of its codes say.
// Codes of the spindle, the coolant and the overrides, by the `value` of their rows.
inline constexpr int kClockwise = 3, kCounterClockwise = 4, kSpindleStands = 5;
inline constexpr int kMist = 7, kFlood = 8, kCoolantOff = 9;
inline constexpr int kOverridesOn = 48, kOverridesOff = 49, kFeedOverride = 50, kSpeedOverride = 51;
inline constexpr int kAdaptiveFeed = 52, kFeedStop = 53;

/// What is switched on or off and moves nothing: M3 to M5, M7 to M9, M48 to M53, G64 P Q, S. M70 and M73 keep it.
struct Switches {
  int spindle = kSpindleStands;
  bool mist = false, flood = false;
  bool feed_override = true, speed_override = true, adaptive_feed = false, feed_stop = true;
  double path_tolerance = 0, naive_tolerance = 0;  // in the program's unit
  double speed = 0;
  bool surface_speed = false;  // G96: the speed is that of the surface
  bool operator==(const Switches&) const = default;
};

struct Modal {
  MotionMode motion = MotionMode::none;
  Plane plane = Plane::xy;
  FeedMode feed_mode = FeedMode::per_minute;
  PathControl path_control = PathControl::continuous;
  bool path_stated = false;          // by the program
  bool length_stated = false;        // of the tool, or that it has none, by the program
  bool unit_stated = false;          // by the program or --unit
  bool inches = false;               // G20
  bool incremental = false;          // G91
  bool arc_centre_absolute = false;  // G90.1
  bool retract_to_r = true;          // G99: cycles end at their R, not where they began
  bool modal_call = false;           // a cycle is called after each move
  int work_system = 1;               // 1..9: G54..G59.3
  double feed = 0;                   // the F in force, in the program's own unit; 0: none. Not used under G93
  double feed_rotary = 0;            // the same as deg/min: it does not follow a change of units
  int tool_in_spindle = -1;          // after M6 or M61; -1: not known
  int tool_of_offset = -1;           // whose length G43 put in force; -1: none, or not a tool of the table
  RotaryRules rotary{};              // how absolute words of A, B and C count
  Switches switches;

  bool operator==(const Modal&) const = default;
  /// mm, or deg, of a word of this axis that says 1.
  double unit_of(Axis axis) const { return inches && !is_rotary(axis) ? kMmPerInch : 1; }
  RotaryRule rule_of(Axis axis) const { return is_rotary(axis) ? rotary[index(axis) - 3] : RotaryRule::linear; }
};

}  // namespace plumbline::nc
