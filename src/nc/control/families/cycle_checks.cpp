// What must hold before a cycle is made.
#include <cmath>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/families/cycle_codes.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kNoTurnDeg = 1e-9;

// There the control takes the axes of the plane for others, one place on, and taps somewhere else [LinuxCNC, measured].
void check_tapped_plane(const Execution& run, int code) {
  const bool taps = is_tap(code);
  if (!taps || run.control.modal.plane == Plane::xy || run.settings.as_with_empty_tables) return;
  run.refuse(run.motion_code(), codes::kNotInterpreted,
             fmt::format("in G18 and G19 the control mixes up the axes of G{} and taps beside the hole", code),
             "tap along Z, with G17 in force");
}

// A0 beside a hole, where A stands at 0: who writes all axes in each block writes it there as well.
bool stays_at(const Execution& run, Axis axis) {
  const Control& control = run.control;
  const RotaryRule rule = control.modal.rule_of(axis);
  const bool reads = run.dialect.behaviour.fanuc_cycles &&
                     (rule == RotaryRule::linear || rule == RotaryRule::shortest) && control.known.contains(axis);
  const double there = control.modal.incremental ? 0 : control.position[axis];
  return reads && std::abs(run.value(axis) - there) < kNoTurnDeg;
}

}  // namespace

// The control stops in the middle of the cycle [LinuxCNC, measured].
void check_cycle_spindle(const Execution& run, int code) {
  const int spindle = run.control.modal.switches.spindle;
  const bool taps = is_tap(code);
  const int needed = code == kTapping ? kClockwise : kCounterClockwise;
  const bool turns = taps ? spindle == needed : spindle != kSpindleStands;
  if (works_spindle(code) && !turns) {
    const std::string_view way = taps && spindle != kSpindleStands ? "turns the other way" : "stands";
    run.refuse(run.motion_code(), codes::kSpindleStands,
               fmt::format("the spindle {}, and the control refuses G{} then", way, code),
               fmt::format("write S and M{} before it; M6 and M19 stop the spindle", taps ? needed : kClockwise));
  }
  check_tapped_plane(run, code);
  const Word* const count = run.words.find('L');
  if (code == kBoreByHand && count != nullptr && count->value > 1 && !run.dialect.behaviour.fanuc_cycles) {
    run.refuse(*count, codes::kNotInterpreted,
               "G88 stops at the bottom of each hole, where the axes may be moved by hand: where the next hole begins "
               "is not known",
               "write each hole in a block of its own, behind a G0 that names all axes");
  }
}

// What a cycle takes for granted.
void check_cycle(const Execution& run) {
  const Control& control = run.control;
  if (const AxisSet rotary = run.axes & AxisSet::rotary(); !rotary.empty()) {
    for (const Axis axis : kAllAxes) {
      if (!rotary.contains(axis) || stays_at(run, axis)) continue;
      run.refuse(*run.words.find(axis), codes::kAxesUnused, "rotary axes stand still in a cycle",
                 "turn to the hole's direction with G0 before");
    }
  }
  if (control.modal.feed_mode == FeedMode::inverse_time) {
    run.refuse(run.motion_code(), codes::kFeedMissing, "a cycle takes no inverse time (G93)", "write G94 before it");
  }
  AxisSet known = control.modal.incremental ? control.known : control.known | run.axes;
  const Axis along_hole = axes_of(control.modal.plane).third;
  if (!control.known.contains(along_hole)) known.erase(along_hole);
  const AxisSet missing = AxisSet::linear() - known;
  if (missing.empty()) return;
  run.refuse(
      run.motion_code(), codes::kPositionUnknown,
      fmt::format("the cycle begins where {} is not known", axis_list(missing)),
      fmt::format("move there with a G0 that names all three; if the axes stand where they stood before {} above it, "
                  "say so: --keeps-position with that code{}",
                  run.dialect.behaviour.return_levels ? "M0, M1, M6 or G116" : "M0, M1 or M6",
                  run.dialect.behaviour.return_levels ? ", M6 for G116" : ""));
}

}  // namespace plumbline::nc
