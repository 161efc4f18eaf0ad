#include "nc/control/second_pass.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace plumbline::nc {

namespace {

constexpr double kSamePlace = 1e-6;  // mm or deg

}  // namespace

void SecondPass::begin(const Control& control) {
  began_ = true;
  begin_ = control.frame.to_machine(control.position);
  begin_known_ = control.known;
  path_ = control.modal.path_control;
}

void SecondPass::note_codes(const Execution& run) {
  if (!began_) begin(run.control);
  if (moved_ && moved_z_ && drilled_ && writes_tables_) return;
  bool incremental = run.control.modal.incremental;
  for (const Chosen& chosen : run.chosen) {
    const auto action = static_cast<std::size_t>(chosen.row->action);
    if (!moved_) before_moves_.set(action);
    if (!moved_z_) before_z_.set(action);
    if (!drilled_) before_holes_.set(action);
    if (!moved_ && chosen.row->action == Action::local_shift) shifted_ = shifted_ | run.axes;
    if (chosen.row->action == Action::absolute) incremental = false;
    if (chosen.row->action == Action::incremental) incremental = true;
    const bool writes = chosen.row->action == Action::set_work_table || chosen.row->action == Action::set_table;
    if (writes) writes_tables_ |= moved_ || incremental;
  }
}

void SecondPass::note_motions(const Execution& run) {
  if (run.motions.empty()) return;
  note_places(run);
  moved_ = true;
  drilled_ |= run.control.modal.motion == MotionMode::cycle;
  for (const Axis axis : kAllAxes) moved_z_ |= axis != Axis::X && axis != Axis::Y && run.axes.contains(axis);
}

// A cut goes from where the tool stands; a rapid takes along what it does not name.
void SecondPass::note_places(const Execution& run) {
  if (placed_ == AxisSet::all()) return;
  const auto is = [&](auto test) { return std::any_of(run.motions.begin(), run.motions.end(), test); };
  const bool moves = is([](const Motion& motion) { return motion.kind != MotionKind::dwell; });
  if (!moves) return;
  const bool in_machine = is([](const Motion& motion) { return motion.in_machine_coordinates; });
  const AxisSet named = run.control.modal.incremental && !in_machine ? AxisSet{} : run.axes;
  const bool cuts =
      is([](const Motion& motion) { return motion.kind != MotionKind::rapid && motion.kind != MotionKind::dwell; });
  if (!in_machine) leans_ = leans_ | (AxisSet::all() - placed_ - (cuts ? AxisSet{} : named));
  placed_ = placed_ | named;
}

std::string SecondPass::other_place(const Control& control) const {
  const AxisWords end = control.frame.to_machine(control.position);
  for (const Axis axis : kAllAxes) {
    if (!leans_.contains(axis) || !begin_known_.contains(axis)) continue;
    if (control.known.contains(axis) && std::abs(end[axis] - begin_[axis]) < kSamePlace) continue;
    return fmt::format("another place of {}", letter(axis));
  }
  return "";
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
  const bool moves = stated({Action::rapid, Action::feed, Action::arc_cw, Action::arc_ccw, Action::cycle});
  const bool returns = before_holes_.test(static_cast<std::size_t>(Action::retract_to_start)) ||
                       before_holes_.test(static_cast<std::size_t>(Action::retract_to_r));
  if (modal.incremental && !stated({Action::absolute, Action::incremental})) return "G91";
  if (modal.inches != settings.inches.value_or(false) && !stated({Action::inches, Action::millimetres}))
    return modal.inches ? "G20" : "G21";
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
  for (const Axis axis : kAllAxes) {
    if (control.local[axis] != 0 && !shifted_.contains(axis)) return "a shift by G52";
  }
  if (control.frame.g92 != AxisWords{}) return "a shift by G92";
  if (control.frame.tool != AxisWords{} && !stated_length()) return "a tool's length";
  if (modal.path_control != path_ && !stated({Action::exact_path, Action::exact_stop, Action::continuous}))
    return "another path control, G61 or G64";
  if (std::string place = other_place(control); !place.empty()) return place;
  if (const HandedVariable* variable = control.of_main.first_carried())
    return fmt::format("another {}, set in line {}", variable->name, variable->line);
  return writes_tables_ ? "other offsets, which G10 wrote" : "";
}

}  // namespace plumbline::nc
