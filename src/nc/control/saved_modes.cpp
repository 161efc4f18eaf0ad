#include "nc/control/saved_modes.hpp"

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {

namespace {

// The codes that stand for what mist and flood do; -1: none.
int mist_code(const Switches& switches) {
  if (switches.mist) return kMist;
  return switches.flood ? -1 : kCoolantOff;
}

// The control looks at the override of the feed alone [LinuxCNC, measured].
int override_code(const Switches& switches) { return switches.feed_override ? kOverridesOn : kSpeedOverride; }

// What has no code for "off" stays on, and M51 switches one override on and none off [interp_convert.cc, gen_m_codes].
void restore_switches(Switches& switches, const Switches& saved) {
  const Switches found = switches;
  switches.spindle = saved.spindle;
  switches.surface_speed = saved.surface_speed;
  const int mist = mist_code(saved);
  if (mist != mist_code(found)) {
    if (mist == kCoolantOff) switches.mist = switches.flood = false;
    if (mist == kMist) switches.mist = true;
  }
  if (saved.flood && !found.flood) switches.flood = true;
  if (const int code = override_code(saved); code != override_code(found)) {
    switches.speed_override = true;
    if (code == kOverridesOn) switches.feed_override = true;
  }
  switches.adaptive_feed = found.adaptive_feed || saved.adaptive_feed;
  switches.feed_stop = found.feed_stop || saved.feed_stop;
}

void restore_path_control(Modal& modal, const Modal& saved) {
  modal.path_control = saved.path_control;
  if (saved.path_control != PathControl::continuous) return;
  modal.switches.path_tolerance = saved.switches.path_tolerance;
  modal.switches.naive_tolerance = saved.switches.naive_tolerance;
}

// The number that the control prints into the block which it then executes.
double printed(double value, int decimals) { return parse_number(fmt::format("{:.{}f}", value, decimals)).value(); }

// F and S come back with one decimal and none; a change of the feed mode alone drops F. The control looks at the number
// that was written last, whatever unit it counted: F100 under G20 where F100 was kept under G21 stays what it is. G93
// leaves it, until a move sets its own.
void restore_feed_and_speed(Execution& run, const SavedModes& saved) {
  Control& control = run.control;
  Modal& modal = control.modal;
  const bool inverse = modal.feed_mode == FeedMode::inverse_time;
  const bool feed_differs = saved.modal.feed_rotary != (inverse ? control.feed_kept : modal.feed_rotary);
  if (saved.modal.feed_mode != modal.feed_mode) set_feed_mode(run, saved.modal.feed_mode);
  if (feed_differs && modal.feed_mode != FeedMode::inverse_time) {
    modal.feed = modal.feed_rotary = printed(saved.modal.feed_rotary, 1);
    control.feed_linear = modal.feed * control.length_unit();
  }
  if (saved.modal.switches.speed != modal.switches.speed) {
    control.spindle_speed = modal.switches.speed = printed(saved.modal.switches.speed, 0);
  }
}

// Whether the shift of G92 is in force comes back, not its words.
void restore_shift(Execution& run, const SavedModes& saved) {
  const Control& control = run.control;
  if (saved.g92_applied == control.g92.applied) return;
  const bool same_either_way = control.g92.known && control.g92.suspended == control.frame.g92;
  if (!saved.g92_applied && same_either_way && control.frame.g92 == AxisWords{}) return;
  if (!saved.g92_applied) {
    run.refuse(codes::kWorkOffsetUnknown,
               "whether the control's offset of G92 was in force when the modes were kept is not known",
               "write G92.1 or G92.2 before M70 or M73, or give the control's #5210 to #5216: --variables FILE");
  }
  clear_position(run, *saved.g92_applied ? Action::restore_position : Action::suspend_position);
  run.step.g92_restored = saved.g92_applied;
}

}  // namespace

SavedModes save_modes(const Control& control) {
  return {control.modal, control.frame.tool != AxisWords{}, control.g92.applied};
}

// The length unit comes back in a block of its own, the others together [interp_convert.cc, restore_settings].
void restore_modes(Execution& run, const SavedModes& saved, const Block& block) {
  Control& control = run.control;
  Modal& modal = control.modal;
  run.block = &block;
  if (modal.inches != saved.modal.inches) control.change_unit(saved.modal.inches);
  restore_feed_and_speed(run, saved);
  restore_switches(modal.switches, saved.modal.switches);
  modal.plane = saved.modal.plane;
  modal.incremental = saved.modal.incremental;
  modal.arc_centre_absolute = saved.modal.arc_centre_absolute;
  modal.retract_to_r = saved.modal.retract_to_r;
  restore_path_control(modal, saved.modal);
  if (saved.tool_length != (control.frame.tool != AxisWords{})) restore_tool_length(run, saved.tool_length);
  if (modal.work_system != saved.modal.work_system) choose_work_system(run, saved.modal.work_system);
  restore_shift(run, saved);
}

}  // namespace plumbline::nc
