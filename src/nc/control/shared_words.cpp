// Words that two codes of a block could take, and codes of which one would do nothing: refused.
#include <algorithm>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

bool takes_axes_itself(const Chosen& code) { return code.row->takes_axes && code.row->group != kMotionGroup; }

bool sets_length(const Chosen& code) { return code.row->action == Action::tool_length; }

// Codes that change where the words of others lead, in an order that no source states.
bool changes_zero(const Chosen& code) {
  switch (code.row->action) {
    case Action::work_system:
    case Action::work_system_by_word:
    case Action::work_system_of_block:
    case Action::tool_length:
    case Action::tool_length_off:
    case Action::turn_on:
    case Action::turn_off:
      return true;
    default:
      return false;
  }
}

// What else of the block the axis words could be for; null: nothing.
const Chosen* other_taker(const Execution& run, const Chosen& taker) {
  const bool sets = taker.row->action == Action::set_position || taker.row->action == Action::set_work_table;
  const bool names = taker.row->action == Action::no_motion;
  for (const Chosen& code : run.chosen) {
    if (&code == &taker || !is_code(*code.word)) continue;
    const Action action = code.row->action;
    const bool moves = code.row->group == kMotionGroup && code.word->letter == 'G' && action != Action::motion_off;
    const bool only_mode = !names && (action == Action::rapid || action == Action::feed);
    const bool to_machine = action == Action::machine_coordinates;
    const bool length = sets_length(code);
    if ((moves && !only_mode) || to_machine || length || (sets && changes_zero(code)) ||
        (takes_axes_itself(code) && &code > &taker)) {
      return &code;
    }
  }
  return nullptr;
}

// G28 Z0 G92 X0, G52 X5 G53 Z0, G10 L2 X5 beside an arc: one of them would go without its words.
void check_axis_words_of_one(const Execution& run) {
  if (!run.dialect.behaviour.fanuc_cycles) return;
  constexpr std::uint32_t kEnds = letter_bit('I') | letter_bit('J') | letter_bit('K') | letter_bit('R');
  const bool no_ends = run.axes.empty() && (run.words.letters() & kEnds) == 0;
  for (const Chosen& code : run.chosen) {
    if (!takes_axes_itself(code)) continue;
    if (no_ends && code.row->action == Action::no_motion) continue;  // G0 G50.1 of a header
    const Chosen* const other = other_taker(run, code);
    if (other == nullptr) continue;
    run.refuse(*other->word, codes::kAxesTwice,
               fmt::format("what {} makes of the words of the axes beside {} was found in no source",
                           run.text_of(*code.word), run.text_of(*other->word)),
               "put them into blocks of their own");
  }
}

// G53 X0 Y0 G43 H1 Z50: Z would be a place of the machine.
void check_length_beside_machine_move(const Execution& run) {
  if (run.machine_word == nullptr || run.axes.empty() || !run.dialect.behaviour.machine_move_is_rapid) return;
  const auto length = std::find_if(run.chosen.begin(), run.chosen.end(), sets_length);
  if (length == run.chosen.end()) return;
  run.refuse(*length->word, codes::kNotInterpreted,
             fmt::format("{} beside {}: whether the length counts in its move was found in no source",
                         run.text_of(*length->word), run.text_of(*run.machine_word)),
             "put them into blocks of their own");
}

// G53 G169 H1: the order in which the two act was found in no source.
void check_end_beside_tip(const Execution& run) {
  const Chosen* const tip = run.chosen_code(Action::tool_tip_on);
  const Chosen* const off = run.chosen_code(Action::tool_length_off);
  if (tip == nullptr || off == nullptr) return;
  run.refuse(*tip->word, codes::kNotInterpreted,
             fmt::format("whether {} or {} of one block says which length counts was found in no source",
                         run.text_of(*off->word), run.text_of(*tip->word)),
             "put them into blocks of their own");
}

// P of G4 and of M98, of G54.1 and of a cycle.
void check_words_of_one(const Execution& run) {
  if (!run.dialect.behaviour.fanuc_cycles) return;
  for (const Word& word : run.block->words) {
    if (is_code(word) || axis_of(word.letter)) continue;
    const std::uint32_t bit = letter_bit(word.letter);
    const Chosen* first = nullptr;
    const bool of_any_move = word.letter == 'F' || word.letter == 'S';
    const bool of_mode =
        run.motion != nullptr && run.motion_word == nullptr && !of_any_move && (run.motion->word_mask & bit) != 0;
    for (const Chosen& code : run.chosen) {
      const bool of_builder = code.row == &run.dialect.user_row;  // which could have any word
      if (!is_code(*code.word) || of_builder || (code.row->word_mask & bit) == 0) continue;
      if (first == nullptr && !of_mode) {
        first = &code;
        continue;
      }
      run.refuse(word, codes::kNotInterpreted,
                 fmt::format("{} belongs to {} or to {}, and which of them the control takes was found in no source",
                             run.text_of(word), first != nullptr ? run.text_of(*first->word) : "the motion in force",
                             run.text_of(*code.word)),
                 "put them into blocks of their own");
    }
  }
}

// G4 P1 G2 X8 I4: the control asks for the codes alone, and takes G4 P1 X8 I4 where the arc is the motion in force.
void check_arc_beside_dwell(const Execution& run) {
  if (run.dialect.behaviour.beside_dwell != ControlBehaviour::Beside::no_arcs) return;
  if (run.chosen_row(Action::dwell) == nullptr) return;
  for (const Chosen& code : run.chosen) {
    if (code.row->action != Action::arc_cw && code.row->action != Action::arc_ccw) continue;
    run.refuse(*code.word, codes::kSameGroup,
               fmt::format("{} beside a dwell, which takes its P as well: the control refuses both in one block",
                           run.text_of(*code.word)),
               "put them into blocks of their own");
  }
}

// The letters whose values count otherwise before such a code than behind it.
std::string_view scaled_by(const Execution& run, Action action) {
  const FeedMode mode = run.control.modal.feed_mode;
  switch (action) {
    case Action::dwell:
      return run.control.modal.inches ? "X" : "";
    case Action::turn_on:
      return run.control.modal.inches ? "R" : "";
    case Action::inverse_time:
      return mode == FeedMode::inverse_time ? "" : "F";
    case Action::per_minute:
      return mode == FeedMode::per_minute ? "" : "F";
    case Action::per_revolution:
      return mode == FeedMode::per_revolution ? "" : "F";
    default:
      return "";
  }
}

// G20 X1. G04 waits for 10 s: a value counts as the codes before it say [B-64114EN 8.3, warning].
void check_values_before_codes(const Execution& run) {
  if (run.dialect.syntax.statements != Statements::macro_b) return;
  for (const Chosen& code : run.chosen) {
    if (!is_code(*code.word)) continue;
    for (const char letter : scaled_by(run, code.row->action)) {
      const Word* const word = run.words.find(letter);
      if (word == nullptr || word->span.begin > code.word->span.begin || word->value == 0) continue;
      run.refuse(*word, codes::kNotInterpreted,
                 fmt::format("{} stands before {}, and a value counts as the codes in front of it say",
                             run.text_of(*word), run.text_of(*code.word)),
                 fmt::format("write {} before {}", run.text_of(*code.word), run.text_of(*word)));
    }
  }
}

// M98 P8 beside M30.
void check_one_way_on(const Execution& run) {
  if (!run.dialect.behaviour.fanuc_cycles) return;
  const Chosen* first = nullptr;
  for (const Chosen& code : run.chosen) {
    const Action action = code.row->action;
    if (action != Action::call_program && action != Action::end_program && action != Action::end) continue;
    if (first != nullptr) {
      run.refuse(*code.word, codes::kSameGroup,
                 fmt::format("{} beside {}: where the program goes on was found in no source", run.text_of(*code.word),
                             run.text_of(*first->word)),
                 "put them into blocks of their own");
    }
    first = &code;
  }
}

// P1 of G43.4 turns the tool in the plane of its two directions, and not A, B and C evenly [A-79294E].
void check_tip_mode(const Execution& run) {
  const auto length = std::find_if(run.chosen.begin(), run.chosen.end(), sets_length);
  if (length == run.chosen.end() || (length->row->word_mask & letter_bit('P')) == 0) return;
  const Word* const word = run.words.find('P');
  if (word == nullptr || word->value == 0) return;
  run.refuse(*word, codes::kNotInterpreted,
             fmt::format("{} of {} asks for another way of turning the tool, which is not interpreted",
                         run.text_of(*word), run.text_of(*length->word)),
             "write P0 or leave it out, so that A, B and C turn evenly");
}

// What NCYL does where no cycle is in force was found in no source, nor what it does alone.
void check_no_hole(const Execution& run) {
  if (run.motion != nullptr && run.motion->action == Action::cycle) return;
  const Chosen* const none = run.chosen_code(Action::no_hole);
  if (none == nullptr) return;
  if (run.motion == nullptr) {
    run.refuse(*none->word, codes::kNotInterpreted,
               fmt::format("what {} does alone was found in no source", run.text_of(*none->word)),
               "write it beside X or Y of the place to go to, or beside the code of a cycle; or leave it out");
  }
  run.refuse(
      *none->word, codes::kNotInterpreted,
      fmt::format("{} says that nothing is drilled, and no drilling cycle is in force", run.text_of(*none->word)),
      "leave it out, or write the cycle before");
}

// Z=VPSLZ goes through as it stands where the place of the axis is not known afterwards, whatever it says: in a rapid
// [P writeRetract].
void check_travel_ends(const Execution& run) {
  const Word* end = nullptr;
  for (const Axis axis : kAllAxes) {
    const Word* const word = run.words.find(axis);
    if (word != nullptr && word->use == WordUse::travel_end) end = word;
  }
  const bool rapid = run.motion != nullptr && run.motion->action == Action::rapid && !run.uses_position_axes;
  if (end == nullptr || rapid) return;
  run.refuse(*end, codes::kNotInterpreted,
             fmt::format("{} is a variable of the control itself, which is read beside G0 alone",
                         run.text_of(*end).substr(run.text_of(*end).find('=') + 1)),
             fmt::format("write G16 H0 G0 {}, or G0 {}9999", run.text_of(*end), end->letter));
}

// NOEX G15 H2, CLEAR F500: whether the rest of such a block is executed was found in no source.
void check_beside_names(const Execution& run) {
  if (run.dialect.syntax.statements != Statements::user_task) return;
  const auto is_name = [](const Chosen& code) { return code.word->letter == kNamedCode && code.row->alone; };
  const auto name = std::find_if(run.chosen.begin(), run.chosen.end(), is_name);
  if (name == run.chosen.end()) return;
  for (const Word& word : run.block->words) {
    const CodeRow* const row = run.dialect.row_of(word);
    if (row != nullptr && word.letter == kNamedCode && row->alone) continue;
    run.refuse(
        word, codes::kNotInterpreted,
        fmt::format("what {} does beside {} was found in no source", run.text_of(word), run.text_of(*name->word)),
        "put the other words into a block of their own");
  }
}

}  // namespace

void check_shared_words(const Execution& run) {
  check_axis_words_of_one(run);
  check_length_beside_machine_move(run);
  check_words_of_one(run);
  check_arc_beside_dwell(run);
  check_values_before_codes(run);
  check_one_way_on(run);
  check_tip_mode(run);
  check_end_beside_tip(run);
  check_no_hole(run);
  check_travel_ends(run);
  check_beside_names(run);
}

}  // namespace plumbline::nc
