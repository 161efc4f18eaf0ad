#include "nc/saved_modes.hpp"

namespace plumbline::nc {

SavedModes save_modes(const Control& control, bool of_call) {
  return {true,
          of_call,
          control.modal,
          control.feed_linear,
          control.feed_rotary,
          control.spindle_speed,
          control.frame.tool};
}

void restore_modes(Execution& run, const SavedModes& saved, const Block& block) {
  Control& control = run.control;
  Modal& modal = control.modal;
  run.block = &block;
  modal.plane = saved.modal.plane;
  modal.feed_mode = saved.modal.feed_mode;
  modal.path_control = saved.modal.path_control;
  modal.inches = saved.modal.inches;
  modal.incremental = saved.modal.incremental;
  modal.arc_centre_absolute = saved.modal.arc_centre_absolute;
  modal.retract_to_r = saved.modal.retract_to_r;
  modal.feed = saved.modal.feed;
  control.feed_linear = saved.feed_linear;
  control.feed_rotary = saved.feed_rotary;
  control.spindle_speed = saved.spindle_speed;
  if (modal.work_system != saved.modal.work_system) {
    modal.work_system = saved.modal.work_system;
    control.use_active_system();
  }
  if (control.frame.tool == saved.tool) return;
  Frame next = control.frame;
  next.tool = saved.tool;
  control.change_frame(next);
  modal.tool_of_offset = saved.modal.tool_of_offset;
}

}  // namespace plumbline::nc
