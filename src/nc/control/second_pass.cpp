#include "nc/control/second_pass.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace plumbline::nc {

void SecondPass::note_codes(const Execution& run) {
  if (moved_ && moved_z_ && drilled_ && writes_tables_) return;
  bool incremental = run.control.modal.incremental;
  for (const Chosen& chosen : run.chosen) {
    const auto action = static_cast<std::size_t>(chosen.row->action);
    if (!moved_) before_moves_.set(action);
    if (!moved_z_) before_z_.set(action);
    if (!drilled_) before_holes_.set(action);
    if (chosen.row->action == Action::absolute) incremental = false;
    if (chosen.row->action == Action::incremental) incremental = true;
    const bool writes = chosen.row->action == Action::set_work_table || chosen.row->action == Action::set_table;
    if (writes) writes_tables_ |= moved_ || incremental;
  }
}

void SecondPass::note_motions(const Execution& run) {
  if (run.motions.empty()) return;
  moved_ = true;
  drilled_ |= run.control.modal.motion == MotionMode::cycle;
  for (const Axis axis : kAllAxes) moved_z_ |= axis != Axis::X && axis != Axis::Y && run.axes.contains(axis);
}

bool SecondPass::stated(std::initializer_list<Action> actions) const {
  return std::any_of(actions.begin(), actions.end(),
                     [&](Action action) { return before_moves_.test(static_cast<std::size_t>(action)); });
}

bool SecondPass::stated_length() const {
  const auto has = [&](Action action) { return before_z_.test(static_cast<std::size_t>(action)); };
  return has(Action::tool_length) || has(Action::tool_length_off);
}

std::string SecondPass::differs(const Control& control, const ProgramSettings& settings) const {
  const Modal& modal = control.modal;
  const bool system = stated({Action::work_system, Action::work_system_by_word});
  const bool fed = stated({Action::per_minute, Action::inverse_time, Action::per_revolution});
  const bool moves =
      stated({Action::rapid, Action::feed, Action::arc_cw, Action::arc_ccw, Action::cycle, Action::motion_off});
  const bool returns = before_holes_.test(static_cast<std::size_t>(Action::retract_to_start)) ||
                       before_holes_.test(static_cast<std::size_t>(Action::retract_to_r));
  if (modal.incremental && !stated({Action::absolute, Action::incremental})) return "G91";
  if (modal.inches && !stated({Action::inches, Action::millimetres})) return "G20";
  if (modal.arc_centre_absolute && !stated({Action::arc_centre_absolute, Action::arc_centre_incremental}))
    return "G90.1";
  if (modal.plane != Plane::xy && !stated({Action::plane_xy, Action::plane_zx, Action::plane_yz})) return "G18 or G19";
  if (modal.feed_mode != FeedMode::per_minute && !fed) return "G93 or G95";
  if (moved_ && modal.motion != MotionMode::rapid && !moves) return "another motion than G0";
  if (drilled_ && modal.retract_to_r && !returns) return "G99";
  if (modal.work_system != 1 && !system) return "another work system than G54";
  if (moved_ && modal.tool_in_spindle != settings.tool_in_spindle.value_or(modal.tool_in_spindle) &&
      !stated({Action::change_tool, Action::set_tool})) {
    return "another tool in the spindle";
  }
  if (control.frame.tilted) return "G68.2";
  if (control.turn_deg != 0 && !stated({Action::turn_off})) return "G68";
  if (control.local != AxisWords{} && !stated({Action::local_shift})) return "a shift by G52";
  if (control.frame.g92 != AxisWords{}) return "a shift by G92";
  if (control.frame.tool != AxisWords{} && !stated_length()) return "a tool's length";
  if (const HandedVariable* variable = control.of_main.first_carried())
    return fmt::format("another {}, set in line {}", variable->name, variable->line);
  return writes_tables_ ? "other offsets, which G10 wrote" : "";
}

}  // namespace plumbline::nc
