// Further work systems and shifts: G54.1 P, G15 H, G10 L2 of Fanuc, G52, G68, TRANS, ROT.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr int kTurns = 1, kScales = 2, kMirrors = 3;  // what the frames of SINUMERIK have as value

int system_of_word(const Execution& run, const CodeRow& row, const Word& word) {
  return row.value + run.whole(word, 1, run.dialect.work_systems - row.value);
}

[[noreturn]] void refuse_plane(const Execution& run, const Word& word) {
  run.refuse(word, codes::kNotInterpreted, "a turn is interpreted about Z alone, in the XY plane (G17)",
             "program the part as it lies, with A, B and C");
}

// The axes stand where they stood, and their words are new; the plane's must both be stated next [B-63684EN 14.6], and
// a move that states both begins there.
void turn(Execution& run, double degrees) {
  Control& control = run.control;
  const bool changes = degrees != control.turn_deg;
  const AxisSet standing = control.known | control.turned;
  control.turn_deg = degrees;
  control.use_active_system();
  if (run.settings.as_with_empty_tables) return;
  if (changes) control.known = control.known - kTurningAxes;
  if (standing.contains(kTurningAxes) && !control.known.contains(kTurningAxes)) control.turned = kTurningAxes;
}

void check_no_g92(const Execution& run, const Word& word) {
  if (run.control.frame.g92 == AxisWords{}) return;
  run.refuse(word, codes::kNotInterpreted, "a shift by G92 and this one together are not interpreted",
             "use a work offset in place of G92");
}

// What R without a point counts is said by a parameter of some series (6400, RTR) [B-63324EN p. 470].
double angle_of_turn(const Execution& run) {
  const Word& word = run.need('R', "G68");
  const bool counts = run.dialect.syntax.statements == Statements::macro_b;
  const bool counted = counts && word.expression == kLiteral && !word.point;
  if (counted && word.value != 0 && !run.settings.calculator_type.value_or(false)) {
    run.refuse(word, codes::kValueUnknown,
               fmt::format("what {} of G68 counts without a point differs between controls", run.text_of(word)),
               "write the angle with a point, in degrees, as in R45.");
  }
  return word.value;
}

// G68 X Y R: about a point of the work system, that where the axes stand if it is not named.
void turn_about_point(Execution& run, const Word& code) {
  Control& control = run.control;
  if (control.modal.plane != Plane::xy) refuse_plane(run, code);
  if (control.turn_deg != 0) {
    run.refuse(code, codes::kNotInterpreted, "a second turn on top of the first is not interpreted",
               "write G69 before it");
  }
  if (counts_increments(run)) {
    run.refuse(code, codes::kNotInterpreted, "what G68 turns by under G91 depends on the control's parameters",
               "write G90 before it");
  }
  for (const Axis axis : kAllAxes) {
    if (!run.axes.contains(axis) || kTurningAxes.contains(axis)) continue;
    run.refuse(*run.words.find(axis), codes::kWordUnused,
               fmt::format("G68 has no use for {}: with Z, I, J and K it turns in space, which is not interpreted",
                           letter(axis)),
               "remove it for a turn in the plane; write G68.2 for a tilted plane, or program A, B and C under G43.4");
  }
  AxisWords centre;
  for (const Axis axis : {Axis::X, Axis::Y}) {
    // A correction would have moved it: only who looks at the program as it stands may take the position.
    if (!run.axes.contains(axis) && !run.settings.as_with_empty_tables) {
      run.refuse(code, codes::kPositionRead, fmt::format("G68 turns about where {} stands", letter(axis)),
                 "name the centre with X and Y");
    }
    centre[axis] = run.axes.contains(axis) ? run.value(axis) : control.position[axis];
  }
  const double degrees = angle_of_turn(run);
  control.local_before_turn = control.local;
  control.local += centre - turned_about_z(centre, degrees);  // shift + R w = c + R (w - c)
  turn(run, degrees);
}

// SCALE alone ends the frame [E]; MIRROR alone may do so as well, and changes nothing where there is none.
void check_frame_ends(const Execution& run, const Chosen& chosen) {
  if (!run.axes.empty()) {
    run.refuse(
        *chosen.word, codes::kNotInterpreted,
        fmt::format("{} mirrors or scales the axes that it names, which is not interpreted", run.text_of(*chosen.word)),
        std::string(kWriteItOut));
  }
  const Control& control = run.control;
  if (chosen.row->value == kScales || (control.local == AxisWords{} && control.turn_deg == 0)) return;
  run.refuse(*chosen.word, codes::kNotInterpreted,
             fmt::format("whether {} ends TRANS and ROT was found in no source", run.text_of(*chosen.word)),
             "write TRANS alone before it");
}

// TRANS and ROT replace the programmable frame, ATRANS and AROT add to it [PG 12.2].
void change_frame_by_name(Execution& run, const Chosen& chosen) {
  Control& control = run.control;
  const bool adds = chosen.row->action == Action::frame_added;
  const bool turns = chosen.row->value == kTurns;
  if (chosen.row->value == kScales || chosen.row->value == kMirrors) check_frame_ends(run, chosen);
  if (adds && run.axes.empty() && !run.words.has('Q')) {
    run.refuse(*chosen.word, codes::kNotInterpreted,
               fmt::format("{} adds nothing, and whether it ends a frame then was found in no source",
                           run.text_of(*chosen.word)),
               turns ? "write ROT alone, or say by how much it turns" : "write TRANS alone, or say what it adds");
  }
  double degrees = adds ? control.turn_deg : 0;
  AxisWords shift = adds ? control.local : AxisWords{};
  if (turns) {
    for (const Axis axis : kAllAxes) {
      if (axis == Axis::Z || !run.axes.contains(axis)) continue;
      const bool turns_nothing = (axis == Axis::X || axis == Axis::Y) && run.value(axis) == 0;  // ROT X0 Y0 Z45
      if (!turns_nothing) refuse_plane(run, *run.words.find(axis));
    }
    if (const Word* word = run.words.find('Q')) {
      if (control.modal.plane != Plane::xy) refuse_plane(run, *word);
      if (run.axes.contains(Axis::X) || run.axes.contains(Axis::Y)) {
        run.refuse(*word, codes::kNotInterpreted, "RPL beside turns by X, Y or Z was found in no source",
                   "write RPL alone, or Z");
      }
      degrees += word->value;  // RPL
    }
    if (const Word* word = run.words.find('Z')) {
      if (run.words.has('Q')) {
        run.refuse(*word, codes::kAxesTwice, "the turn is given by RPL and by Z as well", "leave one of them");
      }
      degrees += word->value;
    }
  } else {
    AxisWords step;
    for (const Axis axis : kAllAxes) {
      if (run.axes.contains(axis)) step[axis] = run.value(axis);
    }
    shift += turned_about_z(step, degrees);
    control.local_added = adds;
  }
  control.local = shift;
  turn(run, degrees);
}

// LinuxCNC has one shift for G52 and G92: G92.1 to G92.3 act on it, whichever of the two set it [measured].
void set_shift_of_g92(Execution& run, const Word& code) {
  if (run.axes.empty()) run.refuse(code, codes::kAxesMissing, "G52 names no axis", "add the words of the shift");
  check_wrapped_words(run);
  Control& control = run.control;
  Frame next = control.frame;
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) next.g92[axis] = run.value(axis);
  }
  control.g92.suspended = next.g92;
  control.g92.known = true;
  control.g92.applied = true;
  control.change_frame(next);
}

void set_local_shift(Execution& run, const Word& code) {
  Control& control = run.control;
  const std::string_view name = run.block->at(code.span);
  if (control.turn_deg != 0) {
    run.refuse(code, codes::kNotInterpreted, fmt::format("{} in a turned system is not interpreted", name),
               "end the turn before it");
  }
  // G58 keeps what ATRANS added; without axes it is a work system of smaller controls.
  if (run.dialect.behaviour.local_shift_adds && (run.axes.empty() || control.local_added)) {
    run.refuse(code, codes::kNotInterpreted,
               run.axes.empty()
                   ? fmt::format("{} without axis words means different things on different controls", name)
                   : fmt::format("{} after ATRANS keeps what that added, which is not interpreted", name),
               "write TRANS with all its axes");
  }
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) control.local[axis] = run.value(axis);
  }
  control.use_active_system();
}

// G10 L10 P1 R100.: the length of offset 1; L11 its wear, L12 and L13 of the radius, which moves nothing without G41.
void set_tool_table(Execution& run, const Word& table, int which) {
  const int number = run.whole(run.need('P', "G10"), 1, kNoLimit);
  const Word& value = run.need('R', "G10");
  if (which >= 12) return;
  Control& control = run.control;
  const auto written = control.tools.find(number);
  const bool has_length = written != control.tools.end();
  const bool adds = which == 11 || control.modal.incremental;
  if (control.frame.tool != AxisWords{} || (adds && !has_length && value.value != 0) ||
      (has_length && which == 11 && value.value != 0)) {
    run.refuse(table, codes::kNotInterpreted,
               control.frame.tool != AxisWords{} ? "a change of tool lengths while one is in force is not interpreted"
                                                 : "a wear, or an increment of a length, is not interpreted",
               "write the whole length with G10 L10 under G90, with G49 before");
  }
  if (which == 11) return;
  ToolRow row;
  row.offset[Axis::Z] = run.length(value);
  control.tools[number] = row;
}

}  // namespace

void choose_work_system(Execution& run, const Chosen& chosen) {
  const bool of_block = chosen.row->action == Action::work_system_of_block;
  if (run.dialect.behaviour.h0_is_machine && run.words.has('H') && run.words.find('H')->value == 0) {
    (of_block ? run.block_in_machine_system : run.control.in_machine_system) = true;
    return;
  }
  if (!of_block) run.control.in_machine_system = false;
  const int system =
      system_of_word(run, *chosen.row, run.need(chosen.row->words.front(), run.block->at(chosen.word->span)));
  if (of_block) run.work_system_before = run.control.modal.work_system;
  choose_work_system(run, system);
}

namespace {

// Words that a row of the table does not have.
void check_words_of_table(const Execution& run, int which) {
  const bool of_tools = which >= 10 && which <= 13;
  for (const Word& word : run.block->words) {
    const bool useless =
        of_tools ? word.letter == 'Q' || axis_of(word.letter).has_value() : word.letter == 'Q' || word.letter == 'R';
    if (!useless) continue;
    run.refuse(word, codes::kWordUnused, fmt::format("G10 L{} has no use for {}", which, word.letter),
               "remove it, or put it into a block of its own");
  }
}

}  // namespace

// G10 L2 P1 to P6, G10 L20 P1...: absolute under G90, added under G91.
void set_work_table(Execution& run) {
  const Word& table = run.need('L', "G10");
  check_no_plane(run, table);
  const int which = run.whole(table, 0, kNoLimit);
  const bool of_tools = which >= 10 && which <= 13;
  if (!of_tools && which != 2 && which != 20) {
    run.refuse(table, codes::kNotInterpreted, fmt::format("G10 L{} is not interpreted", which),
               "it changes tool offsets or parameters of the control; set them before the program runs");
  }
  check_words_of_table(run, which);
  if (of_tools) return set_tool_table(run, table, which);
  const Word& word = run.need('P', "G10");
  const int number = run.whole(word, 0, kNoLimit);
  if (which == 2 && number == 0) {
    run.refuse(word, codes::kNotInterpreted, "the external work offset is not interpreted",
               "add it to the offsets of the work systems");
  }
  const int system = which == 2 ? number : 6 + number;
  if (number < 1 || (which == 2 && number > 6) || system > run.dialect.work_systems) {
    run.refuse(word, codes::kOutOfRange, fmt::format("there is no work system P{}", number),
               which == 2 ? "write P1 to P6" : "write P1 to P300");
  }
  Control& control = run.control;
  if (system == control.modal.work_system && control.frame.g92 != AxisWords{}) {
    run.refuse(table, codes::kNotInterpreted,
               "what becomes of a shift by G92 when the offset under it is written was found in no source",
               "write G10 before G92, or G92.1 before it");
  }
  WorkSystem& row = control.systems[static_cast<std::size_t>(system - 1)];
  for (const Axis axis : kAllAxes) {
    if (!run.axes.contains(axis)) continue;
    if (control.modal.incremental && !row.known.contains(axis)) {
      run.refuse(*run.words.find(axis), codes::kWorkOffsetUnknown, "G91 adds to an offset that was never given",
                 fmt::format("give it, or write G90 before: --work-offset"));
    }
    row.origin[axis] = run.value(axis) + (control.modal.incremental ? row.origin[axis] : 0);
    row.known.insert(axis);
  }
  if (system == control.modal.work_system) control.use_active_system();
}

void change_programmed_frame(Execution& run, const Chosen& chosen) {
  Control& control = run.control;
  const bool with_g92 = chosen.row->action == Action::local_shift && chosen.row->value == 1;
  if (with_g92) return set_shift_of_g92(run, *chosen.word);
  if (chosen.row->action == Action::turn_off && control.frame.tilted) return end_tilted_plane(run);
  check_no_plane(run, *chosen.word);
  check_no_g92(run, *chosen.word);
  switch (chosen.row->action) {
    case Action::local_shift:
      return set_local_shift(run, *chosen.word);
    case Action::turn_on:
      return turn_about_point(run, *chosen.word);
    case Action::turn_off:
      if (control.turn_deg == 0) return;
      control.local = control.local_before_turn;
      return turn(run, 0);
    default:
      return change_frame_by_name(run, chosen);
  }
}

namespace {

// What stands behind the name of a word, brackets and all, without blanks; "": nothing.
std::string values_in_brackets(const Execution& run, const Word& word) {
  const std::string_view text = run.text_of(word);
  return without_blanks(text.substr(std::min(text.find('('), text.size())));
}

void deselect_frame(Execution& run, const Word& code) {
  check_no_plane(run, code);
  if (run.control.local == AxisWords{} && run.control.turn_deg == 0) return;
  run.refuse(code, codes::kNotInterpreted,
             "the control deselects the frame in force here, and machine data say whether it comes back",
             "write TRANS and ROT after it, and TRANS alone before it");
}

}  // namespace

// TRAORI, TRAFOOF: further values of TRAORI turn the tool at its zero and shift the zero of A, B and C [A 6.2.2];
// either deselects the frame before it [W 7.10].
void choose_transformation(Execution& run, const Chosen& chosen) {
  const std::string values = values_in_brackets(run, *chosen.word);
  constexpr std::array<std::string_view, 4> kAsItIs{"", "()", "(1)", "(1,0,0,1)"};
  const std::size_t read = run.text_of(*chosen.word).starts_with("TRAFOOF") ? 2 : kAsItIs.size();
  if (std::find(kAsItIs.begin(), kAsItIs.begin() + read, values) == kAsItIs.begin() + read) {
    run.refuse(*chosen.word, codes::kNotInterpreted,
               "these values choose another transformation, direction of the tool, or zero of A, B and C",
               "TRAORI, TRAORI(1) and TRAORI(1,0,0,1) are interpreted");
  }
  deselect_frame(run, *chosen.word);
}

// CYCLE832(0.02,112103): digits that are there for older programs [N p. 1108], one of which chose a transformation.
void set_tolerances(Execution& run, const Chosen& chosen) {
  run.control.modal.path_control = PathControl::continuous;  // it chooses one of G64 to G645 by itself: none is added
  run.control.modal.path_stated = true;
  const std::string values = values_in_brackets(run, *chosen.word);
  const std::size_t comma = values.find(',');
  if (comma == std::string::npos) return;
  const std::string kind = values.substr(comma + 1, values.find_first_of(",)", comma + 1) - comma - 1);
  if (kind.empty() || kind.front() == '_') return;  // _FINISH and the other names of today
  constexpr std::size_t kDigitsOfToday = 2;
  constexpr std::size_t kFirstOfSurface = 6;
  const bool is_number = std::all_of(kind.begin(), kind.end(), is_digit);
  const std::size_t older = kind.size() - std::min(kind.size(), kFirstOfSurface);
  const bool of_today =
      kind.size() <= kDigitsOfToday ||
      kind.substr(older, kind.size() - older - kDigitsOfToday).find_first_not_of('0') == std::string::npos;
  if (!is_number || !of_today) deselect_frame(run, *chosen.word);
}

// FGROUP(X,Y,Z): F is the speed of these; FGROUP() brings the default back.
void set_feed_group(Execution& run, const Chosen& chosen) {
  const std::string names = upper(values_in_brackets(run, *chosen.word));
  AxisSet group;
  bool as_written = names == "()";
  for (std::size_t i = 1; i + 1 < names.size() && names != "()"; i += 2) {  // (X,Y,Z)
    const std::optional<Axis> axis = axis_of(names[i]);
    as_written = axis && (names[i + 1] == ',' || i + 2 == names.size());
    if (!as_written) break;
    group.insert(*axis);
  }
  const AxisSet linear{Axis::X, Axis::Y, Axis::Z};
  if (!as_written) {
    run.refuse(*chosen.word, codes::kNotInterpreted, "a path group is interpreted as names of axes in brackets alone",
               "write it as in FGROUP(X,Y,Z)");
  } else if (group.empty()) {
    run.control.feed_rule = run.settings.feed_rule.value_or(run.dialect.feed_rule);
  } else if (group == linear) {
    run.control.feed_rule = FeedRule::path_group;
  } else if (group == AxisSet::all()) {
    run.control.feed_rule = FeedRule::all_axes_as_mm;
  } else {
    run.refuse(*chosen.word, codes::kNotInterpreted, "a path group of these axes is not interpreted",
               "FGROUP(X,Y,Z), FGROUP(X,Y,Z,A,B,C) and FGROUP() are");
  }
}

}  // namespace plumbline::nc
