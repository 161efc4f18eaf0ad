// G33 and G33.1: the spindle leads, the axes follow it by K a turn.
#include <cmath>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {

void move_synchronised(Execution& run) {
  Control& control = run.control;
  const bool taps = run.motion->action == Action::rigid_tap;
  need_offsets(run);
  const Word& pitch = run.need('K', taps ? "G33.1" : "G33");
  const int spindle = control.modal.switches.spindle;
  if (spindle == kSpindleStands || control.spindle_speed == 0) {
    run.refuse(run.motion_code(), codes::kFeedMissing, "the spindle leads this move and does not turn",
               "write S and M3 before it");
  }
  if (const Word* const feed = run.words.find('F')) {
    run.refuse(*feed, codes::kWordUnused, "the spindle leads this move, and an F beside it is an error of the control",
               "leave F out: K is the way of one turn");
  }
  for (const Axis axis : kAllAxes) {
    if (!taps || !is_rotary(axis) || !run.axes.contains(axis)) continue;
    run.refuse(*run.words.find(axis), codes::kAxesUnused,
               "the control taps along X, Y and Z alone, and takes A, B and C for moved all the same",
               "turn to the hole's direction with G0 before");
  }
  if (run.axes.empty()) {
    run.refuse(run.motion_code(), codes::kAxesMissing, "the block names no axis", "add X, Y or Z");
  }
  run.step.role = BlockRole::synchronised;
  Motion motion;
  motion.kind = MotionKind::feed;
  motion.to = end_of_move(run);
  motion.known_after = known_after_move(run);
  motion.feed = std::abs(run.length(pitch));
  const AxisWords start = control.position;
  add_motion(run, motion);
  run.motions.back().feed_mode = FeedMode::per_revolution;
  if (!taps) return;
  motion.to = start;  // and back, the spindle turning the other way
  add_motion(run, motion);
  run.motions.back().feed_mode = FeedMode::per_revolution;
}

}  // namespace plumbline::nc
