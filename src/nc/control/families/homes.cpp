// G28 and G30: through a point to a stored position; G28.1 and G30.1 store it. G20 HP=4 of the OSP.
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/rotary.hpp"

namespace plumbline::nc {
namespace {

// In a turned work system X and Y are known together or not at all.
AxisSet known_in_work(const Frame& frame, AxisSet known_in_machine) {
  const AxisSet mixed = frame.mixed();
  return known_in_machine.contains(mixed) ? known_in_machine : known_in_machine - mixed;
}

struct HomeEnd {
  AxisWords words;
  AxisSet known;
  AxisSet changed;  // whose words are others then
};

// Each axis of the machine goes home by itself: on a tilted plane that changes the words of all three.
HomeEnd end_on_plane(const Control& control, const Home& home, AxisSet moved) {
  const Frame frame = control.frame.without_rotary_tool();
  const AxisSet plane = frame.mixed();
  AxisWords machine = frame.to_machine(control.position);
  for (const Axis axis : kAllAxes) {
    if ((moved & home.known).contains(axis)) machine[axis] = home.machine[axis];
  }
  HomeEnd end{frame.from_machine(machine), home.known - plane, moved};
  if ((moved & plane).empty()) return end;
  end.changed = moved | plane;
  if (home.known.contains(moved & plane) && control.known.contains(plane - moved)) end.known = end.known | plane;
  return end;
}

// The control takes home as a word of the axis: its sign says which way round, in the turn in which the axis stands
// [LinuxCNC WRAPPED_ROTARY, measured]. With an offset of the axis it is neither that of the place nor of the machine.
double end_at_home(const Execution& run, Axis axis, const Home& home, double end) {
  const Control& control = run.control;
  if (!is_wrapped(run, axis)) return end;
  if (end != home.machine[axis] || std::abs(end) >= kFullTurn) {
    run.refuse(
        run.first_word(), codes::kNotInterpreted,
        fmt::format("which way round {} goes home is known where its words have a sign (--rotary) and it has no "
                    "offset and a home within one turn",
                    letter(axis)),
        fmt::format("name the axes that go home without {} (G28 Z0), and send it to its place by a word of its own",
                    letter(axis)));
  }
  const bool known = control.surely_known().contains(axis);
  return rotary_end(RotaryRule::sign, end, std::signbit(end),
                    known ? std::optional(control.position[axis]) : std::nullopt);
}

// Alarm PS0044: G27 to G30 are not allowed in a canned cycle.
void check_no_cycle(const Execution& run) {
  const bool drills = run.control.modal.motion == MotionMode::cycle;
  if (!drills || run.dialect.syntax.statements != Statements::macro_b) return;
  if (sets_motion(run) || run.chosen_row(Action::motion_off) != nullptr) return;
  run.refuse(run.first_word(), codes::kNotInterpreted,
             "the control stops at a way home while a drilling cycle is in force", "write G80 before it");
}

}  // namespace

void go_home(Execution& run, int which) {
  Control& control = run.control;
  check_no_cycle(run);
  check_tool_unit(run, run.first_word());
  check_no_rotary_words(run);
  const bool takes_number = (run.chosen_row(Action::go_home)->word_mask & letter_bit('P')) != 0;
  if (const Word* word = takes_number ? run.words.find('P') : nullptr) {
    const bool of_fanuc = run.dialect.syntax.statements == Statements::macro_b;
    run.whole(*word, of_fanuc ? 2 : 1, of_fanuc ? 4 : kNoLimit);
  }
  run.step.role = BlockRole::machine_move;
  if (run.axes.empty() && run.dialect.behaviour.bare_home_loses_position) return lose_position(run, AxisSet::all());
  Motion through;
  through.in_machine_coordinates = true;
  through.to = end_of_move(run);
  through.known_after = known_after_move(run);
  add_motion(run, through);

  const Home& home = control.homes[static_cast<std::size_t>(which)];
  const AxisSet moved = run.axes.empty() ? AxisSet::all() : run.axes;
  const HomeEnd home_end = control.frame.tilted
                               ? end_on_plane(control, home, moved)
                               : HomeEnd{control.frame.without_rotary_tool().from_machine(home.machine),
                                         known_in_work(control.frame, home.known), moved};
  const auto& [end, known, changed] = home_end;
  Motion motion;
  motion.in_machine_coordinates = true;
  motion.to = control.position;
  motion.known_after = control.known;
  for (const Axis axis : kAllAxes) {
    if (!changed.contains(axis)) continue;
    if (known.contains(axis)) {
      motion.to[axis] = end_at_home(run, axis, home, end[axis]);
      motion.known_after.insert(axis);
    } else {
      motion.known_after.erase(axis);
    }
  }
  add_motion(run, motion);
  if (!known.contains(changed)) run.step.loses_position = true;
  end_length_at_home(run);
  if (control.frame.tilted) lose_position(run, AxisSet::linear());
}

void store_home(Execution& run, int which) {
  const Control& control = run.control;
  Home& home = run.control.homes[static_cast<std::size_t>(which)];
  home.machine = control.frame.to_machine(control.position);
  for (const Axis axis : kAllAxes) {  // [interp_convert.cc, convert_savehome]
    if (is_wrapped(run, axis)) home.machine[axis] = within_one_turn(home.machine[axis]);
  }
  home.known = known_in_work(control.frame, control.known);
  run.step.role = BlockRole::stores_position;
}

void home_or_unit(Execution& run, const Chosen& chosen) {
  if (run.words.has('2')) {  // HP=
    run.step.role = BlockRole::machine_move;
    return lose_position(run, AxisSet::all());
  }
  if (chosen.row->value == 0) return;
  run.refuse(
      *chosen.word, codes::kNotInterpreted,
      fmt::format("{} without a home position says that the program is in inches", run.block->at(chosen.word->span)),
      "write the program in mm, which this control takes everywhere, or name the home position: HP=");
}

}  // namespace plumbline::nc
