// Moves whose end or way only the machine knows, so that their blocks go through as they stand: to the end of an axis'
// travel (Z9999), in machine coordinates by H0, into tool-tip mode (G169).
#include <cmath>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

const Word& first_word_of(const Execution& run, AxisSet axes) {
  for (const Axis axis : kAllAxes) {
    if (axes.contains(axis)) return *run.words.find(axis);
  }
  return run.motion_code();
}

[[noreturn]] void refuse_increment(const Execution& run, AxisSet axes) {
  run.refuse(first_word_of(run, axes), codes::kNotInterpreted,
             "where increments (G91) lead in machine coordinates, or to the end of the travel, was found in no source",
             "write G90 before it");
}

// Where the named axes stand after it is known but for those of `lost`.
void go_as_it_stands(Execution& run, AxisSet lost) {
  const Control& control = run.control;
  Motion motion;
  motion.kind = MotionKind::rapid;
  motion.in_machine_coordinates = true;
  motion.to = control.position;
  motion.known_after = control.known;
  for (const Axis axis : kAllAxes) {
    if (!run.axes.contains(axis)) continue;
    if (lost.contains(axis)) {
      motion.known_after.erase(axis);
    } else {
      motion.to[axis] = run.value(axis);
      motion.known_after.insert(axis);
    }
  }
  run.step.role = BlockRole::machine_move;
  if (!lost.empty()) run.step.loses_position = true;
  add_motion(run, motion);
}

// G0 A0 B0 C0 of a header before the first G15 [P onSection, positionABC]: what they count from depends on what ran
// before. X, Y and Z are refused there: no post writes them, and that G15 was forgotten would show in no other way.
AxisSet axes_without_system(const Execution& run) {
  AxisSet axes;
  const Modal& modal = run.control.modal;
  const bool chosen = modal.work_system != 0 || !run.dialect.behaviour.no_work_system_at_start;
  if (chosen || modal.incremental || run.motion->action != Action::rapid) return axes;
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    if (run.axes.contains(axis) && modal.rule_of(axis) == RotaryRule::linear) axes.insert(axis);
  }
  return axes;
}

}  // namespace

AxisSet axes_to_limits(const Execution& run) {
  AxisSet axes;
  const double limit = run.dialect.behaviour.travel_limit_mm;
  if (limit <= 0 || run.motion == nullptr || run.motion->action != Action::rapid) return axes;
  for (const Axis axis : kAllAxes) {
    if (!run.axes.contains(axis) || is_rotary(axis)) continue;
    const bool ends = run.words.find(axis)->use == WordUse::travel_end;  // Z=VPSLZ
    if (ends || std::abs(run.value(axis)) >= limit) axes.insert(axis);
  }
  return axes;
}

bool move_as_it_stands(Execution& run) {
  const bool in_machine_system = run.in_machine_system();
  const AxisSet limits = in_machine_system ? run.axes : axes_to_limits(run) | axes_without_system(run);
  if (!in_machine_system && limits.empty()) return false;
  if (in_machine_system && run.motion->action != Action::rapid) need_offsets(run);  // says why not
  if (run.axes.empty()) return true;
  if (run.control.modal.incremental) refuse_increment(run, limits);
  if (limits != run.axes) need_offsets(run);
  go_as_it_stands(run, limits);
  return true;
}

void set_tool_tip(Execution& run, const Chosen& chosen) {
  Control& control = run.control;
  if (chosen.row->action == Action::tool_tip_off) {
    if (control.length != Control::Length::by_tip) return;
    control.length = Control::Length::unknown;
    const bool tilted = tilts_tool(run, control.known, control.position);
    return lose_position(run, tilted ? AxisSet::linear() : AxisSet{Axis::Z});
  }
  if (run.words.has('H')) set_tool_length(run, chosen);
  if (run.axes.empty()) return;
  if (control.modal.incremental) refuse_increment(run, run.axes);
  need_offsets(run);
  const bool in_rapid = control.motion_row != nullptr && control.motion_row->action == Action::rapid;
  if (!in_rapid && run.chosen_row(Action::rapid) == nullptr) {
    run.refuse(*chosen.word, codes::kNotInterpreted,
               fmt::format("{} with words of the axes is known behind G0 alone: whether it moves at a feed, or drills, "
                           "where another motion is in force was found in no source",
                           run.text_of(*chosen.word)),
               "write G0 into the block before it");
  }
  AxisSet limits;
  for (const Axis axis : kAllAxes) {
    const double limit = run.dialect.behaviour.travel_limit_mm;
    const bool there = run.axes.contains(axis) && !is_rotary(axis) && limit > 0;
    if (there && std::abs(run.value(axis)) >= limit) limits.insert(axis);
  }
  go_as_it_stands(run, limits);
}

}  // namespace plumbline::nc
