#include "nc/saved_modes.hpp"

#include "nc/codes.hpp"
#include "nc/interpreter.hpp"

namespace plumbline::nc {

SavedModes save_modes(const Control& control, bool of_call) {
  return {true, of_call, control.modal, control.feed_linear, control.spindle_speed, control.frame.tool};
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
  modal.feed_rotary = saved.modal.feed_rotary;
  control.feed_linear = saved.feed_linear;
  control.spindle_speed = saved.spindle_speed;
  modal.switches = saved.modal.switches;
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

void Interpreter::enter_subprogram(bool own_parameters, const std::vector<double>& arguments) {
  control_.parameters.enter(own_parameters);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    control_.parameters.set(static_cast<int>(i) + 1, {arguments[i], true});
  control_.parameters.set("_value", {});
  control_.parameters.set("_value_returned", {});
  saved_.emplace_back();
}

void Interpreter::enter_subprogram(int own_variables) {
  if (own_variables < 0) {
    control_.parameters.enter_sharing();
  } else {
    control_.parameters.enter_with_own(own_variables);
  }
  saved_.emplace_back();
}

void Interpreter::set_macro_arguments() {
  for (const auto& [number, value] : run_.arguments) control_.parameters.set(number, value);
}

void Interpreter::leave_subprogram(const Block& block) {
  control_.parameters.leave();
  const SavedModes modes = saved_.back();
  saved_.pop_back();
  if (modes.valid && modes.of_call) restore_modes(run_, modes, block);
}

void Interpreter::act_on_saved_modes(const Chosen& chosen) {
  run_.step.saves_modes = true;
  switch (chosen.row->action) {
    case Action::forget_modes:
      saved_.back().valid = false;
      return;
    case Action::restore_modes:
      if (!saved_.back().valid) {
        run_.refuse(*chosen.word, codes::kModesNotSaved, "no modes were saved here", "save them with M70 before");
      }
      return restore_modes(run_, saved_.back(), *run_.block);
    default:
      saved_.back() = save_modes(control_, chosen.row->action == Action::save_modes_of_call);
  }
}

}  // namespace plumbline::nc
