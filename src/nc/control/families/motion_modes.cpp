// The motion in force: what sets it, what ends it, and the move that it makes.
#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/families/cycle_codes.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

// Splines, probing and what the spindle leads; false: some other motion.
bool moves_specially(Execution& run, Action action) {
  const bool spline = action == Action::cubic_spline || action == Action::quadratic_spline;
  const bool nurbs = action == Action::nurbs_point || action == Action::nurbs_end;
  const bool spindle_leads = action == Action::synchronised || action == Action::rigid_tap;
  if (!spline && !nurbs && !spindle_leads && action != Action::probe) return false;
  if (run.machine_word != nullptr) {
    run.refuse(*run.machine_word, codes::kMachineMove,
               fmt::format("{0} needs G0 or G1", run.text_of(*run.machine_word)),
               fmt::format("write the motion code into the block of {0}", run.text_of(*run.machine_word)));
  }
  if (spline) move_spline(run);
  if (!spline) run.control.spline_end.reset();
  if (action == Action::nurbs_point) add_nurbs_point(run);
  if (action == Action::nurbs_end) move_nurbs(run);
  if (spindle_leads) move_synchronised(run);
  if (action == Action::probe) move_probe(run);
  if (spline) return true;  // in force for its own block alone; the motion before goes on [LinuxCNC, measured]
  const bool nurbs_ended = action == Action::nurbs_end;
  run.control.motion_end = nurbs_ended ? Control::MotionEnd::nurbs_end : Control::MotionEnd::none;
  run.control.motion_row = nurbs_ended ? nullptr : run.motion;
  run.control.modal.motion = nurbs_ended ? MotionMode::none : MotionMode::special;
  return true;
}

// The first move after a turn, where it names both axes of the plane.
void begin_after_turn(Execution& run) {
  Control& control = run.control;
  const bool absolute = run.machine_word == nullptr && absolute_words(run).contains(control.turned);
  if (absolute && !control.turned.empty()) {
    control.known = control.known | control.turned;
    run.step.new_place = control.turned;
  }
}

// On an OSP G1 and a cycle are of different groups: whether the one ends the other was found in no source; posts write
// G0 or G80.
void check_ends_cycle(const Execution& run, Action action, const Word& word) {
  const bool in_cycle = run.control.modal.motion == MotionMode::cycle;
  if (!run.dialect.behaviour.return_levels || !in_cycle || action == Action::rapid) return;
  run.refuse(word, codes::kNotInterpreted,
             "whether this ends the drilling cycle that is in force was found in no source",
             "write G80 (which stops the spindle) or a block with G0 before it");
}

// Alarm PS0204: an axis moves between M29 and the G84 or G74 that it is for.
void check_after_rigid_code(Execution& run) {
  const bool taps = run.motion->action == Action::cycle && is_tap(run.motion->value);
  if (run.control.rigid_tap_due && !taps && !run.axes.empty()) {
    run.refuse(run.first_word(), codes::kNotInterpreted,
               "the control stops where an axis moves between M29 and its G84",
               "write M29 right before the block of G84 or G74, and moves before it");
  }
  if (taps) run.control.rigid_tap_due = false;
}

}  // namespace

void state_motion_mode(Execution& run, const Chosen& chosen) {
  check_ends_cycle(run, chosen.row->action, *chosen.word);
  set_motion_mode(run, *chosen.row);
}

void set_motion_mode(Execution& run, const CodeRow& row) {
  run.control.cycle.begun = false;
  const bool circle = row.action == Action::arc_through_point;  // CIP is stated anew in each block
  run.control.motion_row = circle ? nullptr : &row;
  run.control.motion_end = circle ? Control::MotionEnd::circle : Control::MotionEnd::none;
  run.control.modal.motion = row.action == Action::rapid    ? MotionMode::rapid
                             : row.action == Action::feed   ? MotionMode::feed
                             : row.action == Action::arc_cw ? MotionMode::arc_cw
                                                            : MotionMode::arc_ccw;
}

void end_motion(Execution& run) {
  Modal& modal = run.control.modal;
  if (run.dialect.behaviour.rapid_after_cycles && modal.motion != MotionMode::cycle) return;
  const CodeRow* const goes_on = row_after_cycle(run);
  run.control.cycle.begun = false;
  run.control.spline_end.reset();
  modal.motion = goes_on != nullptr ? MotionMode::rapid : MotionMode::none;
  run.control.motion_row = goes_on;
  run.control.motion_end = Control::MotionEnd::off;
}

void make_motion(Execution& run) {
  const Action action = run.motion->action;
  check_offsets_of_motion(run);
  check_after_rigid_code(run);
  begin_after_turn(run);
  if (action == Action::cycle) return move_in_cycle(run);
  check_ends_cycle(run, action, run.motion_code());
  if (run.machine_word != nullptr && run.dialect.behaviour.machine_move_is_rapid) {
    move_straight(run);
    if (run.motion_word != nullptr) set_motion_mode(run, *run.motion);  // G53 G0: G0 is the mode from here on
    return;
  }
  run.control.cycle.begun = false;
  if (moves_specially(run, action)) return;
  run.control.spline_end.reset();
  if (run.control.motion_stated) set_motion_mode(run, *run.motion);
  if (action != Action::rapid && action != Action::feed) {
    move_arc(run);
  } else {
    move_straight(run);
  }
  drill_after_move(run);
}

}  // namespace plumbline::nc
