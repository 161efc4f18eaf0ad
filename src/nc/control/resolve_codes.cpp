// Which motion a block makes, whether all of its words are used, and in which order its codes act.
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/characters.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/user_function.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr std::uint32_t kAxisLetters =
    letter_bit('X') | letter_bit('Y') | letter_bit('Z') | letter_bit('A') | letter_bit('B') | letter_bit('C');
constexpr std::uint32_t kFreeLetters = letter_bit('F') | letter_bit('S') | letter_bit('T');  // need no code
constexpr std::uint32_t kCentreBits = letter_bit('I') | letter_bit('J') | letter_bit('K');

bool is_arc(const CodeRow* row) {
  return row != nullptr &&
         (row->action == Action::arc_cw || row->action == Action::arc_ccw || row->action == Action::arc_through_point);
}

bool is_tool_length(Action action) {
  return action == Action::tool_length_by_words || action == Action::tool_length_added;
}

// Spindle 0 is the only one that is followed here; -1 is all of them.
void check_spindle(const Execution& run, const Word& word) {
  const bool moves = run.motion != nullptr && run.motion->takes_axes;
  if (word.value == 0 || (word.value == -1 && !moves)) return;
  run.refuse(word, codes::kNotInterpreted, fmt::format("{} is a spindle that is not interpreted", run.text_of(word)),
             "programs that turn several spindles are not read; the first one is $0");
}

// Codes that take the axis words, other than a motion: G10, G28, G92... and the tool length codes.
struct AxisTakers {
  const Chosen* motion = nullptr;
  const Chosen* other = nullptr;
  bool tool_length = false;
  bool turns_off = false;  // G80
};

AxisTakers axis_takers(Execution& run) {
  AxisTakers takers;
  for (const Chosen& chosen : run.chosen) {
    if (chosen.word->letter != 'G' && chosen.word->letter != kNamedCode) continue;
    if (chosen.row->action == Action::motion_off) {
      takers.turns_off = true;
      continue;
    }
    if (chosen.row->group == 1) takers.motion = &chosen;
    if (chosen.row->action == Action::machine_coordinates) run.machine_word = chosen.word;
    if (!chosen.row->takes_axes || chosen.row->group == 1) continue;
    if (is_tool_length(chosen.row->action)) {
      takers.tool_length = true;
    } else {
      takers.other = &chosen;
    }
  }
  return takers;
}

// G2 I5, or a cycle.
bool goes_without_axes(const Execution& run) {
  const auto of_arc = kCentreBits | (run.dialect.behaviour.radius_alone_stands ? 0 : letter_bit('R'));
  return run.motion->action == Action::cycle || (is_arc(run.motion) && (run.words.letters() & of_arc) != 0);
}

// Before the first motion code: where no F is known either, a control that begins with G1 stops with an alarm.
const CodeRow* motion_before_codes(const Execution& run) {
  const Control& control = run.control;
  const bool fed = control.modal.feed != 0 || run.words.has('F');
  if (!run.dialect.behaviour.rapid_before_codes || control.motion_stated || fed) return nullptr;
  return run.dialect.g_code(0);
}

// G0 G169 Z50 H1, as posts write it: the words are G169's, and G0 is the mode from here on [P onSection].
bool is_rapid_of_tip(const AxisTakers& takers) {
  return takers.other->row->action == Action::tool_tip_on && takers.motion->row->action == Action::rapid;
}

// J of G131 J1 E0.02 is its own where an arc is in force [P setSmoothing].
std::uint32_t words_of_alone(const Execution& run) {
  std::uint32_t words = 0;
  for (const Chosen& chosen : run.chosen) words |= chosen.row->alone ? chosen.row->word_mask : 0;
  return words;
}

// An explicit motion, or the one in force if there are words for it that nobody else takes.
void find_motion(Execution& run) {
  const AxisTakers takers = axis_takers(run);
  run.motion = nullptr;
  run.motion_word = nullptr;
  if (run.machine_word != nullptr && run.dialect.behaviour.machine_move_is_rapid && takers.other == nullptr) {
    run.uses_position_axes = false;
    if (takers.motion != nullptr) run.motion_word = takers.motion->word;
    run.motion = run.axes.empty() ? nullptr : run.dialect.g_code(0);  // G53 is a rapid, whatever is in force
    return;
  }
  run.uses_position_axes = takers.other != nullptr;
  if (takers.motion != nullptr) {
    run.control.motion_stated = true;
    if (takers.other != nullptr && (run.dialect.behaviour.group_0_takes_axes || is_rapid_of_tip(takers))) return;
    if (takers.other != nullptr) {
      run.refuse(*takers.motion->word, codes::kAxesTwice,
                 fmt::format("{} and {} both take the axis words", run.text_of(*takers.motion->word),
                             run.text_of(*takers.other->word)),
                 "put them into blocks of their own");
    }
    run.motion = takers.motion->row;
    run.motion_word = takers.motion->word;
    if (run.dialect.behaviour.bare_motion_code_is_mode && run.axes.empty() && !goes_without_axes(run) &&
        run.vector == nullptr)
      run.motion = nullptr;
    return;
  }
  if (takers.turns_off && takers.tool_length && !run.axes.empty() &&
      run.dialect.syntax.statements == Statements::o_words) {
    run.refuse(first_axis_word(run), codes::kAxesTwice, "G80 stands beside words of axes, which the control refuses",
               "put G80 into a block of its own before");
  }
  if (takers.other != nullptr || takers.tool_length) return;
  const CodeRow* mode = takers.turns_off ? row_after_cycle(run) : run.control.motion_row;
  const bool centre = is_arc(mode) && (run.words.letters() & kCentreBits & ~words_of_alone(run)) != 0;
  if (run.axes.empty() && !centre && run.vector == nullptr) return;
  if (mode == nullptr) mode = motion_before_codes(run);
  constexpr std::uint32_t kPointBits = letter_bit('1') | letter_bit('2') | letter_bit('3');
  const bool points = run.dialect.syntax.word_modes && (run.words.letters() & kPointBits) != 0;
  if (mode == nullptr && (points || run.control.motion_end == Control::MotionEnd::circle)) {
    run.refuse(
        first_axis_word(run), codes::kAxesUnused, "a circle through a point states its CIP in each block",
        points ? "write CIP into this block as well" : "write G0, G1, G2 or G3 here, or CIP with I1=, J1= or K1=");
  }
  if (mode == nullptr) {
    run.refuse(first_axis_word(run), codes::kAxesUnused, "no motion code is in force for these axis words",
               "write G0, G1, G2 or G3 before them");
  }
  run.motion = mode;
}

void check_machine_coordinates(const Execution& run) {
  const CodeRow* const stated = run.motion_word == nullptr ? nullptr : run.dialect.row_of(*run.motion_word);
  if (run.dialect.behaviour.machine_move_is_rapid && stated != nullptr && stated->action != Action::rapid) {
    run.refuse(*run.motion_word, codes::kMachineMove, "G53 moves at rapid, and this asks for a feed",
               "write G0 into the block of G53");
  }
  const bool straight =
      run.motion != nullptr && (run.motion->action == Action::rapid || run.motion->action == Action::feed);
  const bool moves_nothing =
      run.dialect.behaviour.bare_motion_code_is_mode && run.motion == nullptr && run.axes.empty();
  if (!straight && !moves_nothing) {
    run.refuse(*run.machine_word, codes::kMachineMove,
               fmt::format("{0} needs G0 or G1", run.text_of(*run.machine_word)),
               fmt::format("write the motion code into the block of {0}", run.text_of(*run.machine_word)));
  }
}

// X-9.09e-13
bool is_exponent(const Execution& run, const Word& word) {
  const std::uint32_t at = word.span.begin;
  return word.letter == 'E' && at > 0 && (is_digit(run.block->text[at - 1]) || run.block->text[at - 1] == '.');
}

// D0 H0 of a header: no offset is in force that they could change.
std::uint32_t numbers_without_offset(const Execution& run) {
  if (run.chosen_row(Action::call_program) != nullptr) return letter_bit('D');
  const bool ends = run.chosen_row(Action::tool_length_off) != nullptr;
  return letter_bit('D') | (ends || run.control.frame.tool == AxisWords{} ? letter_bit('H') : 0);
}

// R3. in a block of its own, H2 under G43: controls differ in what they make of it.
void refuse_kept_word(const Execution& run, const Word& word) {
  const CodeRow* const mode = run.control.motion_row;
  const bool of_cycle =
      mode != nullptr && mode->action == Action::cycle && (mode->word_mask & letter_bit(word.letter)) != 0;
  if (of_cycle && run.motion == nullptr &&
      (run.dialect.behaviour.fanuc_cycles || run.dialect.behaviour.return_levels)) {
    run.refuse(
        word, codes::kWordUnused,
        fmt::format("{} stands in a drilling cycle without a hole: whether that drills again, or is kept for the "
                    "next hole, differs between controls",
                    run.text_of(word)),
        "put it into the block of the next hole, beside X and Y");
  }
  if (word.letter != 'H' || !run.dialect.behaviour.offset_numbers_last) return;
  run.refuse(word, codes::kWordUnused,
             "whether another H takes its length without G43, and how Z moves then, differs between controls",
             "write G43 (or G44) beside it, with Z");
}

// I J K of G68, P of G53.1.
void refuse_word_of_plane(const Execution& run, const Word& word) {
  if ((letter_bit(word.letter) & kCentreBits) != 0 && run.chosen_row(Action::turn_on) != nullptr) {
    run.refuse(word, codes::kWordUnused, "G68 with I, J and K turns about an axis in space, which is not interpreted",
               "write G68.2 for a tilted plane, or program A, B and C under G43.4");
  }
  if (word.letter == 'P' && run.chosen_row(Action::tool_on_plane) != nullptr) {
    run.refuse(word, codes::kWordUnused,
               "P of G53.1 chooses between positions of the rotary axes, which is not interpreted",
               "leave it out; --free-rotation says what C does");
  }
}

// M98 P2 H5: on controls that read as a Fanuc; there Q is of this kind.
void refuse_word_of_call(const Execution& run, const Word& word) {
  if ((word.letter != 'Q' && word.letter != 'H') || run.chosen_row(Action::call_program) == nullptr) return;
  run.refuse(word, codes::kWordUnused,
             fmt::format("{} of a call says at which block the subprogram begins, which is not read", word.letter),
             "make what begins there a subprogram of its own, and call that");
}

// G83 I3. J0.5 K1. [H, G83]: pecks that become smaller.
void refuse_peck_of_haas(const Execution& run, const Word& word) {
  const bool drills = run.motion != nullptr && run.motion->action == Action::cycle;
  if (!drills || run.dialect.syntax.statements != Statements::macro_b || (letter_bit(word.letter) & kCentreBits) == 0)
    return;
  run.refuse(
      word, codes::kWordUnused,
      fmt::format("{} is no word of this cycle but on a Haas, which goes down in smaller and smaller pecks by it",
                  word.letter),
      "write Q, the depth of each peck, in their place");
}

// TURN of TURN=2, X of X5.
std::string_view name_of(const Execution& run, const Word& word) {
  const std::string_view text = run.text_of(word);
  const std::size_t equals = text.find('=');
  return text.substr(0, equals == std::string_view::npos ? 1 : text.find_first_of("= \t"));
}

// P2 beside an arc: P only stands for TURN= here.
bool is_letter_of_name(const Execution& run, const Word& word) {
  return (run.dialect.syntax.address_letters & letter_bit(word.letter)) != 0 &&
         upper(run.text_of(word).front()) == word.letter;
}

void check_words_used(const Execution& run) {
  std::uint32_t used = kFreeLetters | kAxisLetters;
  if (run.dialect.has_edges) used |= letter_bit('D');
  if (run.dialect.behaviour.offset_numbers_last) used |= numbers_without_offset(run);
  if (run.motion != nullptr && run.machine_word == nullptr) used |= letter_bit('@') | letter_bit('^');
  if (run.motion != nullptr) used |= run.motion->word_mask;
  if (run.vector != nullptr) used |= kCentreBits;
  for (const Chosen& chosen : run.chosen) used |= chosen.row->word_mask;
  const std::uint32_t unused = run.words.letters() & ~used;
  const bool has_names = (run.words.letters() & run.dialect.syntax.address_letters) != 0;
  if (unused == 0 && !has_names) return;
  for (const Word& word : run.block->words) {
    if (is_code(word)) continue;
    if ((letter_bit(word.letter) & unused) == 0 && !(has_names && is_letter_of_name(run, word))) continue;
    if (is_exponent(run, word)) {
      run.refuse(word, codes::kWordUnused, "numbers have no exponent: the control reads E as a word of its own",
                 "write the number out, X0.0000001 or X0, and have the post-processor write fixed decimals");
    }
    refuse_word_of_call(run, word);
    refuse_kept_word(run, word);
    refuse_word_of_plane(run, word);
    refuse_peck_of_haas(run, word);
    // FP has the letter, too.
    const bool is_h = word.letter == 'H' && upper(run.text_of(word)[0]) == 'H';
    if (is_h && run.dialect.syntax.declared)
      run.refuse(word, codes::kUserCode, user_function_text(run.text_of(word)), std::string(kUserFunctionHelp));
    const bool waits = word.letter == 'P' && run.chosen_row(Action::dwell) != nullptr;
    run.refuse(word, codes::kWordUnused, fmt::format("no code of this block uses the {} word", name_of(run, word)),
               waits ? "the time of a dwell is F here, in seconds: write it as in G4 F0.5"
                     : "remove it, or add the code that it belongs to");
  }
}

int turn_of(const Chosen& chosen) { return chosen.row->step * 2 + (chosen.row->group == 1 ? 1 : 0); }

}  // namespace

const Word& polar_word(const Execution& run) {
  const Word* const radius = run.words.find('@');
  const Word* const word = radius != nullptr ? radius : run.words.find('^');
  PLUMBLINE_CHECK(word != nullptr);
  return *word;
}

const Word& first_axis_word(const Execution& run) {
  for (const Axis axis : kAllAxes) {
    if (const Word* word = run.words.find(axis)) return *word;
  }
  if (run.words.polar()) return polar_word(run);
  return run.vector != nullptr ? *run.vector : run.block->words.front();
}

void resolve_codes(Execution& run) {
  run.machine_word = nullptr;
  gather_codes(run);
  if (!run.chosen.empty() && run.chosen.back().row->action == Action::call_macro) {
    check_words_before_call(run);
    run.motion = nullptr;
    return;
  }
  check_beside_dwell(run);
  check_alone(run);
  find_tool_vector(run);
  find_motion(run);
  check_tool_vector(run);
  check_words_used(run);
  if (const Word* spindle = run.words.find('$')) check_spindle(run, *spindle);
  check_contexts(run);
  if (run.machine_word != nullptr && (run.motion != nullptr || !run.dialect.behaviour.machine_move_is_rapid)) {
    check_machine_coordinates(run);
  }
  if (run.chosen.size() > 1) {
    std::stable_sort(run.chosen.begin(), run.chosen.end(),
                     [](const Chosen& a, const Chosen& b) { return turn_of(a) < turn_of(b); });
  }
}

}  // namespace plumbline::nc
