// Work offsets: G54 to G59.3, G10 L2 and L20, the G92 family.
#include <algorithm>
#include <initializer_list>
#include <string_view>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/control/state/system_parameters.hpp"
#include "nc/language/block_words.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

int system_of(const Execution& run) {
  const Word& word = run.need('P', "G10");
  const int system = run.whole(word, 0, run.dialect.work_systems);
  return system == 0 ? run.control.modal.work_system : system;
}

// G10 L2 P3 X1 M68 E0 Q2: the Q is M68's.
bool belongs_to_another(const Execution& run, char letter) {
  return std::any_of(run.chosen.begin(), run.chosen.end(), [&](const Chosen& chosen) {
    return chosen.row->action != Action::set_table && (chosen.row->word_mask & letter_bit(letter)) != 0;
  });
}

void refuse_useless(const Execution& run, std::string_view code, std::initializer_list<char> letters) {
  for (const char letter : letters) {
    const Word* const word = run.words.find(letter);
    if (word == nullptr || belongs_to_another(run, letter)) continue;
    run.refuse(*word, codes::kWordUnused, fmt::format("{} has no use for {}", code, letter), "remove it");
  }
}

// G10 L2: the origin in machine coordinates, absolute whatever G90 and G91 say.
void set_origin(Execution& run) {
  Control& control = run.control;
  const int system = system_of(run);
  WorkSystem& row = control.systems[static_cast<std::size_t>(system - 1)];
  refuse_useless(run, "G10 L2", {'I', 'J', 'Q'});
  for (const Axis axis : kAllAxes) {
    if (!run.axes.contains(axis)) continue;
    row.origin[axis] = run.value(axis);
    row.known.insert(axis);
  }
  const double rotation = row.rotation_deg;
  if (const Word* word = run.words.find('R')) row.rotation_deg = word->value;
  if (system != control.modal.work_system) return;
  control.use_changed_row();
  const bool shifted = control.frame.g92[Axis::X] != 0 || control.frame.g92[Axis::Y] != 0;
  // The control errs then about where it stands.
  if (shifted && row.rotation_deg != rotation) lose_position(run, kTurningAxes);
}

// G10 L20: the origin moves so that the axes stand on the given words. With p = origin + R (work + G92) and p
// unchanged, the origin goes by R (where they stand now - the given words).
void set_origin_here(Execution& run) {
  Control& control = run.control;
  const int system = system_of(run);
  WorkSystem& row = control.systems[static_cast<std::size_t>(system - 1)];
  refuse_useless(run, "G10 L20", {'R', 'I', 'J', 'Q'});
  check_wrapped_words(run);
  const bool turns = row.rotation_deg != 0 && !(run.axes & kTurningAxes).empty();
  need_position(run, turns ? run.axes | kTurningAxes : run.axes);
  if (turns && !row.known.contains(kTurningAxes - run.axes)) need_offsets(run);
  Frame there = control.frame;
  there.origin = row.origin;
  there.rotation_deg = row.rotation_deg;
  const bool is_active = system == control.modal.work_system;
  const AxisWords now = is_active ? control.position : there.from_machine(control.frame.to_machine(control.position));
  AxisWords shift;
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) shift[axis] = now[axis] - run.value(axis);
  }
  row.origin += turned_about_z(shift, row.rotation_deg);
  row.known = row.known | run.axes;
  run.step.role = BlockRole::sets_offset;
  run.step.offset_rotation_deg = row.rotation_deg;
  if (!is_active) return;
  control.frame.origin = row.origin;
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) control.position[axis] = run.value(axis);
  }
}

}  // namespace

// What G92 and G10 L20 read: where the named axes stand.
void need_position(const Execution& run, AxisSet axes) {
  for (const Axis axis : kAllAxes) {
    if (!axes.contains(axis) || run.control.known.contains(axis)) continue;
    const Word* const word = run.words.find(axis);
    run.refuse(word != nullptr ? *word : run.first_word(), codes::kPositionUnknown,
               fmt::format("the offset would depend on where {} stands, which is not known", letter(axis)),
               way_to_position(run.control));
  }
}

void choose_work_system(Execution& run, int system) {
  const bool changes = system != run.control.modal.work_system;
  if (changes) check_no_plane(run, run.first_word());
  if (run.dialect.behaviour.set_position_unknown_elsewhere && run.control.frame.g92 != AxisWords{}) {
    run.refuse(codes::kNotInterpreted,
               changes
                   ? "whether what G92 set counts in another work system as well was found in no source"
                   : "whether what G92 set still counts where its work system is chosen again was found in no source",
               "choose the work system before G92");
  }
  run.control.modal.work_system = system;
  run.control.use_active_system();
}

void set_table(Execution& run) {
  const Word& word = run.need('L', "G10");
  const int table = run.whole(word, 0, kNoLimit);
  switch (table) {
    case 1:
      return set_tool_row(run);
    case 2:
      return set_origin(run);
    case 20:
      return set_origin_here(run);
    case 10:
    case 11:
      return set_tool_row_here(run, table == 11);
    case 0:  // the table is read anew, and is the one that --tools gives
      if (run.control.modal.tool_in_spindle <= 0) return;
      run.refuse(word, codes::kNotInterpreted, "the control stops at G10 L0 while a tool is in the spindle",
                 "leave it out, or put it before T and M6, or after T0 M6");
    default:
      run.refuse(word, codes::kOutOfRange, fmt::format("there is no G10 L{}", table), "write L1, L2, L10, L11 or L20");
  }
}

namespace {

void check_no_local_shift(const Execution& run, std::string_view name) {
  if (run.control.local == AxisWords{}) return;
  run.refuse(codes::kNotInterpreted, fmt::format("what {} leaves of a shift by G52 is not interpreted", name),
             "end the shift before it, with G52 X0 Y0 Z0");
}

}  // namespace

void set_position(Execution& run) {
  Control& control = run.control;
  check_wrapped_words(run);
  check_no_plane(run, run.first_word());
  if (run.axes.empty()) {
    run.refuse(codes::kAxesMissing, "G92 names no axis", "add the words that the axes shall stand on");
  }
  check_no_local_shift(run, "G92");  // some controls end it for the axes that G92 names [NCT 9.2.4]
  if (run.in_machine_system() || !control.active().known.contains(run.axes)) need_offsets(run);
  need_position(run, run.axes);
  if (run.dialect.behaviour.set_position_unknown_elsewhere && control.modal.incremental) {
    run.refuse(codes::kNotInterpreted, "what G92 sets under G91 was found in no source", "write G90 before it");
  }
  for (const Axis axis : kAllAxes) {
    if (!run.axes.contains(axis)) continue;
    control.frame.g92[axis] += control.position[axis] - run.value(axis);
    control.position[axis] = run.value(axis);
  }
  control.g92.suspended = control.frame.g92;
  control.g92.known = true;
  control.g92.applied = true;
  run.step.role = BlockRole::sets_offset;
  run.step.offset_rotation_deg = control.frame.rotation_deg;
}

namespace {

// The control brings the named axes back to the work offset, whatever shifted them: a tool's length and G52 as well.
void preset_named_axes(Execution& run) {
  Control& control = run.control;
  check_no_local_shift(run, "G92.1");
  if (control.frame.tool != AxisWords{}) {
    run.refuse(codes::kNotInterpreted, "G92.1 while a tool's length is in force is not interpreted",
               "write G49 before it");
  }
  Frame next = control.frame;
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) next.g92[axis] = 0;
  }
  control.g92.suspended = next.g92;
  control.g92.applied = next.g92 != AxisWords{};
  control.change_frame(next);
}

}  // namespace

void clear_position(Execution& run, Action action) {
  Control& control = run.control;
  check_no_plane(run, run.first_word());
  if (const CodeRow* const row = run.chosen_row(action); row != nullptr && row->needs_axes) {
    return preset_named_axes(run);
  }
  const bool restores = action == Action::restore_position;
  if (restores && !control.g92.known) {
    run.refuse(codes::kWorkOffsetUnknown,
               "the control keeps the offset of G92 from programs before, and it was never given",
               "write G92 in this program, or give the control's #5211 to #5216: --variables FILE");
  }
  Frame next = control.frame;
  next.g92 = restores ? control.g92.suspended : AxisWords{};
  control.g92.applied = restores;
  if (action == Action::clear_position) {
    control.g92.suspended = AxisWords{};
    control.g92.known = true;
  }
  control.change_frame(next);
}

}  // namespace plumbline::nc
