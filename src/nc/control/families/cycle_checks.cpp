// What must hold before a cycle is made.
#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/families/cycle_codes.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

// There the control takes the axes of the plane for others, one place on, and taps somewhere else [LinuxCNC, measured].
void check_tapped_plane(const Execution& run, int code) {
  const bool taps = code == kTapping || code == kLeftTapping;
  if (!taps || run.control.modal.plane == Plane::xy || run.settings.as_with_empty_tables) return;
  run.refuse(run.motion_code(), codes::kNotInterpreted,
             fmt::format("in G18 and G19 the control mixes up the axes of G{} and taps beside the hole", code),
             "tap along Z, with G17 in force");
}

}  // namespace

// The control stops in the middle of the cycle [LinuxCNC, measured].
void check_cycle_spindle(const Execution& run, int code) {
  const int spindle = run.control.modal.switches.spindle;
  const bool taps = code == kTapping || code == kLeftTapping;
  const int needed = code == kTapping ? kClockwise : kCounterClockwise;
  const bool turns = taps ? spindle == needed : spindle != kSpindleStands;
  if (works_spindle(code) && !turns) {
    const std::string_view way = taps && spindle != kSpindleStands ? "turns the other way" : "stands";
    run.refuse(run.motion_code(), codes::kSpindleStands,
               fmt::format("the spindle {}, and the control refuses G{} then", way, code),
               fmt::format("write S and M{} before it; M6 and M19 stop the spindle", taps ? needed : kClockwise));
  }
  check_tapped_plane(run, code);
}

}  // namespace plumbline::nc
