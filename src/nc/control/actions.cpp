// Which code does what.
#include <algorithm>
#include <optional>
#include <string>

#include "base/text/characters.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/families/cycle_codes.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {

bool sets_motion(const Execution& run) {
  return std::any_of(run.chosen.begin(), run.chosen.end(), [](const Chosen& code) {
    return code.row->group == kMotionGroup && code.row->action != Action::motion_off && code.word->letter != 'M';
  });
}

namespace {

// Modes that are one value each; false: the action is none of these.
bool set_mode(Modal& modal, Action action) {
  switch (action) {
    case Action::plane_xy:
      modal.plane = Plane::xy;
      return true;
    case Action::plane_zx:
      modal.plane = Plane::zx;
      return true;
    case Action::plane_yz:
      modal.plane = Plane::yz;
      return true;
    case Action::absolute:
    case Action::incremental:
      modal.incremental = action == Action::incremental;
      return true;
    case Action::arc_centre_absolute:
    case Action::arc_centre_incremental:
      modal.arc_centre_absolute = action == Action::arc_centre_absolute;
      return true;
    case Action::exact_path:
      modal.path_control = PathControl::exact_path;
      modal.path_stated = true;
      return true;
    case Action::exact_stop:
      modal.path_control = PathControl::exact_stop;
      modal.path_stated = true;
      return true;
    case Action::retract_to_start:
    case Action::retract_to_r:
      modal.retract_to_r = action == Action::retract_to_r;
      return true;
    default:
      return false;
  }
}

// G53 X0: a rapid whatever mode is in force, which it leaves alone.
bool is_rapid_of_machine(const Execution& run) {
  return run.machine_word != nullptr && run.motion_word == nullptr && run.dialect.behaviour.machine_move_is_rapid;
}

// The feed stays what it is in mm/min; F of a rotary move stays what was written [LinuxCNC, measured].
void change_unit(Execution& run, const Word& code, bool inches) {
  run.control.modal.unit_stated = true;
  if (run.control.modal.inches == inches) return;
  if (run.dialect.behaviour.unit_change_length_unknown && run.control.frame.tool != AxisWords{}) {
    run.refuse(code, codes::kNotInterpreted,
               "what the tool length in force is worth after a change of units depends on a parameter of the control "
               "(5006 OIM)",
               "write G49 before the change, and G43 after it; this control's manual asks for it at the begin");
  }
  run.control.change_unit(inches);
  if (!run.dialect.behaviour.unit_change_drops_feed) return;
  // What F is worth then stands in no source.
  run.control.modal.feed = run.control.feed_linear = run.control.modal.feed_rotary = 0;
}

void act_on_mode(Execution& run, const Chosen& chosen) {
  Modal& modal = run.control.modal;
  if (set_mode(modal, chosen.row->action)) return;
  // Of another code of the block it would be something else: P is TURN= beside G64 of the 840D.
  const auto own = [&](char letter) -> std::optional<double> {
    if (chosen.row->words.find(letter) == std::string::npos || !run.words.has(letter)) return std::nullopt;
    return run.words.find(letter)->value;
  };
  switch (chosen.row->action) {
    case Action::motion_off:
      if (run.dialect.behaviour.cycle_off_stops_spindle) modal.switches.spindle = kSpindleStands;
      if ((run.motion == nullptr || is_rapid_of_machine(run)) && !sets_motion(run)) end_motion(run);
      return;
    case Action::surface_speed:
      if (chosen.row->value == 1) run.need('S', run.text_of(*chosen.word));
      run.control.modal.switches.surface_speed = chosen.row->value == 1;
      return;
    case Action::inches:
      return change_unit(run, *chosen.word, true);
    case Action::millimetres:
      return change_unit(run, *chosen.word, false);
    case Action::inverse_time:
      return set_feed_mode(run, FeedMode::inverse_time);
    case Action::per_minute:
      return set_feed_mode(run, FeedMode::per_minute);
    case Action::per_revolution:
      return set_feed_mode(run, FeedMode::per_revolution);
    case Action::continuous:
      modal.path_control = PathControl::continuous;
      modal.path_stated = true;
      modal.switches.path_tolerance = own('P').value_or(0);
      modal.switches.naive_tolerance = own('Q').value_or(-1);
      if (modal.switches.naive_tolerance < 0) modal.switches.naive_tolerance = modal.switches.path_tolerance;
      return;
    case Action::work_system:
      return choose_work_system(run, chosen.row->value);
    default:
      return;  // compensation_off, machine_coordinates, no_motion
  }
}

// SETMS and SETMS(1) are the spindle that is followed here.
void check_main_spindle(const Execution& run, const Word& word) {
  const std::string_view text = run.text_of(word);
  const std::string values = without_blanks(text.substr(std::min(text.find_first_of("(=["), text.size())));
  if (values.empty() || values == "()" || values == "(1)") return;
  run.refuse(word, codes::kNotInterpreted,
             "this makes another spindle the one that S, M3 to M5 and feeds per revolution are of",
             "programs that turn several spindles are not read");
}

void act_on_spindle(Execution& run, const Chosen& chosen) {
  if (chosen.row->action == Action::main_spindle) check_main_spindle(run, *chosen.word);
  if (chosen.row->action == Action::position_spindle) {
    run.control.turn_spindle(kSpindleStands);
    run.control.rigid_tap_due = chosen.row->value == kTapping;
  }
  if (chosen.row->action == Action::speed_limit) run.control.speed_limited = true;
}

// Work systems and frames, tilted planes among them; false: another code.
bool act_on_frame(Execution& run, const Chosen& chosen) {
  switch (chosen.row->action) {
    case Action::set_work_table:
      set_work_table(run);
      return true;
    case Action::work_system_by_word:
    case Action::work_system_of_block:
      nc::choose_work_system(run, chosen);
      return true;
    case Action::local_shift:
    case Action::turn_on:
    case Action::turn_off:
    case Action::frame_new:
    case Action::frame_added:
      change_programmed_frame(run, chosen);
      return true;
    case Action::tilted_plane:
      define_tilted_plane(run, chosen);
      return true;
    case Action::tool_on_plane:
      turn_tool(run, chosen);
      return true;
    default:
      return false;
  }
}

// Offsets, homes, tools, and turns of the coordinates.
void act_on_position(Execution& run, const Chosen& chosen) {
  if (act_on_frame(run, chosen)) return;
  switch (chosen.row->action) {
    case Action::set_table:
      return set_table(run);
    case Action::set_position:
      return set_position(run);
    case Action::clear_position:
    case Action::suspend_position:
    case Action::restore_position:
      return clear_position(run, chosen.row->action);
    case Action::go_home:
      return go_home(run, chosen.row->value);
    case Action::store_home:
      return store_home(run, chosen.row->value);
    case Action::tool_length:
    case Action::tool_length_by_words:
    case Action::tool_length_added:
    case Action::tool_length_off:
      run.control.modal.length_stated = true;
      return set_tool_length(run, chosen);
    case Action::no_next_tool:
      return forget_next_tool(run, *chosen.word);
    case Action::tool_tip_on:
    case Action::tool_tip_off:
      run.control.modal.length_stated = true;
      return set_tool_tip(run, chosen);
    case Action::return_level:
      return set_return_level(run, *chosen.word);
    case Action::change_tool:
    case Action::set_tool:
      return change_tool(run, chosen);
    case Action::tolerance_cycle:
      return set_tolerances(run, chosen);
    case Action::transformation:
      return choose_transformation(run, chosen);
    case Action::feed_group:
      return set_feed_group(run, chosen);
    case Action::main_spindle:
    case Action::position_spindle:
    case Action::speed_limit:
      return act_on_spindle(run, chosen);
    case Action::tool_edge:
      return choose_edge(run, *chosen.word);
    case Action::modal_call:
      return set_modal_call(run);
    case Action::called_cycle:
      return call_cycle(run, *chosen.row);
    case Action::swivel:
      return swivel(run, chosen);
    case Action::home_or_unit:
      return home_or_unit(run, chosen);
    case Action::lose_position:
      check_no_modal_call(run, *chosen.word);
      run.step.role = BlockRole::machine_move;
      return nc::lose_position(run, AxisSet::all());
    default:
      return chosen.word->letter == 'M' ? machine_code(run, chosen) : act_on_mode(run, chosen);
  }
}

}  // namespace

void act(Execution& run, const Chosen& chosen) {
  switch (chosen.row->action) {
    case Action::rapid:
    case Action::feed:
    case Action::arc_cw:
    case Action::arc_ccw:
    case Action::arc_through_point:
    case Action::cycle:
    case Action::cubic_spline:
    case Action::quadratic_spline:
    case Action::nurbs_point:
    case Action::nurbs_end:
    case Action::synchronised:
    case Action::rigid_tap:
    case Action::probe:
      if (run.motion == nullptr) return state_motion_mode(run, chosen);
      return make_motion(run);
    case Action::feed_word:
      return set_feed(run, *chosen.word);
    case Action::speed_word:
      if (chosen.word->value < 0) {
        run.refuse(*chosen.word, codes::kNegative, "the spindle speed is negative",
                   "write S0 or more; M4 turns backwards");
      }
      run.refuse_point(*chosen.word);
      if (run.dialect.behaviour.whole_words.find('S') != std::string::npos) {
        whole_number(*run.block, chosen.word->span, chosen.word->value, "the spindle speed");
      }
      run.control.spindle_speed = run.control.modal.switches.speed = chosen.word->value;
      return;
    case Action::tool_word:
      return select_tool(run, *chosen.word);
    case Action::dwell:
      return dwell(run, *chosen.word);
    case Action::call_macro:
      return call_macro(run);
    default:
      return act_on_position(run, chosen);
  }
}

}  // namespace plumbline::nc
