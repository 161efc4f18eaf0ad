// Which codes a block holds, whether they go together, and in which order they act.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/characters.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kCodeTolerance = 1e-3;  // of ten times a G code [LinuxCNC, measured]
constexpr int kUserGroup = 63;
constexpr std::uint32_t kUninterpretedLetters = letter_bit('U') | letter_bit('V') | letter_bit('W');
constexpr std::uint32_t kAxisLetters =
    letter_bit('X') | letter_bit('Y') | letter_bit('Z') | letter_bit('A') | letter_bit('B') | letter_bit('C');
constexpr double kLargestValue = 1e9;  // so that sums of them can be written with all that a double holds of them
constexpr std::uint32_t kFreeLetters = letter_bit('F') | letter_bit('S') | letter_bit('T');  // need no code
constexpr std::uint32_t kCentreBits = letter_bit('I') | letter_bit('J') | letter_bit('K');

std::string text_of(const Execution& run, const Word& word) { return std::string(run.block->at(word.span)); }

bool is_arc(const CodeRow* row) {
  return row != nullptr &&
         (row->action == Action::arc_cw || row->action == Action::arc_ccw || row->action == Action::arc_through_point);
}

bool is_tool_length(Action action) {
  return action == Action::tool_length_by_words || action == Action::tool_length_added;
}

[[noreturn]] void refuse_row(const Execution& run, const CodeRow& row, const Word& word) {
  run.refuse(word, codes::kNotInterpreted, fmt::format("{} {}", text_of(run, word), row.why),
             "write it out in G0, G1, G2 and G3, with the control's simulator or the CAM system");
}

const CodeRow* g_row(const Execution& run, const Word& word) {
  const double times_ten = word.value * 10;
  const double whole = std::round(times_ten);
  const CodeRow* row = nullptr;
  if (std::abs(times_ten - whole) < kCodeTolerance && whole >= 0 && whole < 1e4) {
    row = run.dialect.g_code(static_cast<int>(whole));
  }
  if (row == nullptr) {
    run.refuse(word, codes::kUnknownCode, fmt::format("{} is no G code of this control", text_of(run, word)),
               "look for a slip, or choose another dialect");
  }
  if (row->action == Action::compensation_on) {
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} lets the control offset the path by the tool's radius", text_of(run, word)),
               "let the CAM system write the path of the tool's centre: an offset at the control would turn the "
               "corrections of the path into others");
  }
  if (row->action == Action::refused) refuse_row(run, *row, word);
  return row;
}

const CodeRow* m_row(const Execution& run, const Word& word) {
  const int code = whole_number(*run.block, word.span, word.value, "an M code");
  const CodeRow* row = code < 0 || code > 1000 ? nullptr : run.dialect.m_code(code * 10);
  if (row != nullptr && row->action != Action::refused) return row;
  if (row != nullptr && !run.settings.passed_m_codes.contains(code)) refuse_row(run, *row, word);
  const bool users = code >= run.dialect.first_user_m_code;
  if (run.settings.passed_m_codes.contains(code) || (users && run.settings.as_with_empty_tables)) {
    return &run.dialect.user_row;
  }
  if (!users) {
    run.refuse(
        word, codes::kUnknownCode, fmt::format("{} is no M code of this control", text_of(run, word)),
        fmt::format("look for a slip; a code that the control's builder added goes through with --pass M{}", code));
  }
  run.refuse(
      word, codes::kUserCode, fmt::format("M{} is a code of the machine's builder", code),
      fmt::format("it may change kinematics, offsets or position; if it changes none of them: --pass M{}", code));
}

void choose(Execution& run, const CodeRow* row, const Word& word) { run.chosen.push_back({row, &word}); }

bool is_of_group(const Chosen& code) {
  return code.word->letter == 'G' && code.row->group != 0 && code.row->action != Action::motion_off;
}

// Where the control takes the last one of a group, those before it are as if not written.
void keep_last_of_groups(Execution& run) {
  std::vector<Chosen>& chosen = run.chosen;
  std::size_t kept = 0;
  for (auto code = chosen.begin(); code != chosen.end(); ++code) {
    const auto replaces = [&](const Chosen& next) { return is_of_group(next) && next.row->group == code->row->group; };
    if (is_of_group(*code) && std::any_of(code + 1, chosen.end(), replaces)) continue;
    chosen[kept++] = *code;
  }
  chosen.resize(kept);
}

// Two codes of one modal group cannot both act.
void check_groups(Execution& run) {
  if (run.dialect.behaviour.last_of_group) {
    check_cycle_beside_motion(run);
    return keep_last_of_groups(run);
  }
  std::uint64_t seen_g = 0;
  std::uint64_t seen_m = 0;
  for (const Chosen& chosen : run.chosen) {
    if (!is_code(*chosen.word)) continue;
    if (chosen.row->group < 0 || chosen.row->action == Action::motion_off)
      continue;  // gives way to another motion [LinuxCNC, measured]
    const int group = chosen.row == &run.dialect.user_row ? kUserGroup : chosen.row->group;
    std::uint64_t& seen = chosen.word->letter == 'M' ? seen_m : seen_g;
    if ((seen >> static_cast<unsigned>(group) & 1U) != 0) {
      run.refuse(
          *chosen.word, codes::kSameGroup,
          fmt::format("{} contradicts another code of its modal group in this block", text_of(run, *chosen.word)),
          "put them into blocks of their own");
    }
    seen |= std::uint64_t{1} << static_cast<unsigned>(group);
  }
}

// @ and ^ stand for X and Y.
void plan_polar(Execution& run) {
  const AxisSet plane{Axis::X, Axis::Y};
  for (const Axis axis : {Axis::X, Axis::Y}) {
    if (!run.axes.contains(axis)) continue;
    run.refuse(*run.words.find(axis), codes::kAxesTwice, "the end is given by @ and ^ as well",
               "give either X and Y or radius and angle");
  }
  run.axes = run.axes | plane;
  run.step.end_words = EndWords::polar;
}

const Word& polar_word(const Execution& run) {
  const Word* const radius = run.words.find('@');
  const Word* const word = radius != nullptr ? radius : run.words.find('^');
  PLUMBLINE_CHECK(word != nullptr);
  return *word;
}

// F and S of a dwell are its time, not a feed and a speed; G131 has an F of its own.
void take_words_of_dwell(Execution& run) {
  const auto dwell = std::find_if(run.chosen.begin(), run.chosen.end(), [](const Chosen& chosen) {
    return chosen.row->action == Action::dwell || chosen.row->action == Action::no_motion;
  });
  if (dwell == run.chosen.end()) return;
  const std::uint32_t taken = dwell->row->word_mask;
  std::erase_if(run.chosen, [&](const Chosen& chosen) {
    return (chosen.word->letter == 'F' || chosen.word->letter == 'S') && (letter_bit(chosen.word->letter) & taken) != 0;
  });
}

void refuse_twice(const Execution& run, const Word& word) {
  run.refuse(word, codes::kWordTwice, fmt::format("two {} words in one block", word.letter), "leave one of them");
}

// Only an axis that turns without end has a shorter or a positive way round; G90 counts within its turn then (setting).
void take_word_mode(Execution& run, const Word& word) {
  run.has_word_modes = true;
  const std::optional<Axis> axis = axis_of(word.letter);
  if (word.mode == WordMode::absolute || word.mode == WordMode::incremental || !axis || !is_rotary(*axis)) return;
  RotaryRule& rule = run.control.modal.rotary[index(*axis) - 3];
  if (rule == RotaryRule::linear) rule = RotaryRule::one_turn;
}

[[noreturn]] void refuse_large(const Execution& run, const Word& word) {
  run.refuse(word, codes::kOutOfRange, fmt::format("{} is worth {:.6g}", word.letter, word.value),
             fmt::format("look for a slip or a missing point; words may be worth up to {:.0e}", kLargestValue));
}

// G74 X1=0: a move of struts and carriages to marks of their own.
void check_machine_axis(const Execution& run, const Word& word) {
  const bool taken = std::any_of(run.chosen.begin(), run.chosen.end(),
                                 [](const Chosen& chosen) { return chosen.row->action == Action::lose_position; });
  if (taken) return;
  run.refuse(word, codes::kNotInterpreted, fmt::format("{} moves an axis of the machine itself", text_of(run, word)),
             "write X, Y and Z; axes of the machine stand in a block with G74 or G75");
}

// Spindle 0 is the only one that is followed here; -1 is all of them.
void check_spindle(const Execution& run, const Word& word) {
  const bool moves = run.motion != nullptr && run.motion->takes_axes;
  if (word.value == 0 || (word.value == -1 && !moves)) return;
  run.refuse(word, codes::kNotInterpreted,
             fmt::format("{} is a spindle that is not interpreted", run.block->at(word.span)),
             "programs that turn several spindles are not read; the first one is $0");
}

void gather(Execution& run) {
  run.chosen.clear();
  run.has_word_modes = false;
  bool calls_macro = false;
  const Word* machine_axis = nullptr;
  for (const Word& word : run.block->words) {
    if (calls_macro) continue;  // its words are arguments
    switch (word.letter) {
      case 'G':
        choose(run, g_row(run, word), word);
        calls_macro = calls_macro || run.chosen.back().row->action == Action::call_macro;
        continue;
      case kNamedCode: {
        const CodeRow& row = run.dialect.named_codes[static_cast<std::size_t>(word.value)];
        if (row.action == Action::refused) refuse_row(run, row, word);
        choose(run, &row, word);
        continue;
      }
      case 'M':
        choose(run, m_row(run, word), word);
        check_extended(run, *run.chosen.back().row, word);
        continue;
      case 'F':
        choose(run, &run.dialect.feed_row, word);
        break;
      case 'S':
        choose(run, &run.dialect.speed_row, word);
        break;
      case 'T':
        choose(run, &run.dialect.tool_row, word);
        break;
      case 'D':
        if (run.dialect.has_edges) choose(run, &run.dialect.edge_row, word);
        break;
      default:
        break;
    }
    if (run.dialect.syntax.repeated_ijk && run.words.has(word.letter)) refuse_twice(run, word);
    if (word.mode != WordMode::modal) take_word_mode(run, word);
    if (word.use == WordUse::machine_axis) machine_axis = &word;
    if (!(std::abs(word.value) <= kLargestValue)) refuse_large(run, word);
    if ((letter_bit(word.letter) & kUninterpretedLetters) != 0) {
      run.refuse(word, codes::kNotInterpreted, fmt::format("{} words are not interpreted", word.letter),
                 "the axes are X, Y, Z, A, B and C");
    }
    run.words.add(word);
  }
  run.axes = run.words.axes();
  if (machine_axis != nullptr) check_machine_axis(run, *machine_axis);
  if (run.words.polar()) plan_polar(run);
  if (run.chosen.size() > 1) {
    if (run.dialect.behaviour.dwell_takes_words) take_words_of_dwell(run);
    check_groups(run);
  }
}

const Word& first_axis_word(const Execution& run) {
  for (const Axis axis : kAllAxes) {
    if (const Word* word = run.words.find(axis)) return *word;
  }
  if (run.words.polar()) return polar_word(run);
  return run.vector != nullptr ? *run.vector : run.block->words.front();
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
  return run.motion->action == Action::cycle || (is_arc(run.motion) && (run.words.letters() & kCentreBits) != 0);
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
    if (takers.other != nullptr && run.dialect.behaviour.group_0_takes_axes) return;
    if (takers.other != nullptr) {
      run.refuse(*takers.motion->word, codes::kAxesTwice,
                 fmt::format("{} and {} both take the axis words", text_of(run, *takers.motion->word),
                             text_of(run, *takers.other->word)),
                 "put them into blocks of their own");
    }
    run.motion = takers.motion->row;
    run.motion_word = takers.motion->word;
    if (run.dialect.behaviour.bare_motion_code_is_mode && run.axes.empty() && !goes_without_axes(run) && !run.vector)
      run.motion = nullptr;
    return;
  }
  if (takers.other != nullptr || takers.tool_length) return;
  const CodeRow* const mode = takers.turns_off ? row_behind_cycle(run) : run.control.motion_row;
  const bool centre = is_arc(mode) && (run.words.letters() & kCentreBits) != 0;
  if (run.axes.empty() && !centre && run.vector == nullptr) return;
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
  if (!straight) {
    run.refuse(*run.machine_word, codes::kMachineMove, "G53 needs G0 or G1",
               "write the motion code into the block of G53");
  }
}

// X-9.09e-13
bool is_exponent(const Execution& run, const Word& word) {
  const std::uint32_t at = word.span.begin;
  return word.letter == 'E' && at > 0 && (is_digit(run.block->text[at - 1]) || run.block->text[at - 1] == '.');
}

// D0 H0 of a header: no offset is in force that they could change.
std::uint32_t numbers_without_offset(const Execution& run) {
  const bool ends = run.chosen_row(Action::tool_length_off) != nullptr;
  return letter_bit('D') | (ends || run.control.frame.tool == AxisWords{} ? letter_bit('H') : 0);
}

void check_words_used(const Execution& run) {
  std::uint32_t taken = kFreeLetters | kAxisLetters;
  if (run.dialect.has_edges) taken |= letter_bit('D');
  if (run.dialect.behaviour.offset_numbers_last) taken |= numbers_without_offset(run);
  if (run.motion != nullptr && run.machine_word == nullptr) taken |= letter_bit('@') | letter_bit('^');
  if (run.motion != nullptr) taken |= run.motion->word_mask;
  if (run.vector != nullptr) taken |= kCentreBits;
  for (const Chosen& chosen : run.chosen) taken |= chosen.row->word_mask;
  const std::uint32_t left = run.words.letters() & ~taken;
  if (left == 0) return;
  for (const Word& word : run.block->words) {
    if (is_code(word) || (letter_bit(word.letter) & left) == 0) continue;
    if (is_exponent(run, word)) {
      run.refuse(word, codes::kWordUnused, "numbers have no exponent: the control reads E as a word of its own",
                 "write the number out, X0.0000001 or X0, and have the post-processor write fixed decimals");
    }
    run.refuse(word, codes::kWordUnused, fmt::format("no code of this block uses the {} word", word.letter),
               "remove it, or add the code that it belongs to");
  }
}

int turn_of(const Chosen& chosen) { return chosen.row->step * 2 + (chosen.row->group == 1 ? 1 : 0); }

}  // namespace

void resolve_codes(Execution& run) {
  run.machine_word = nullptr;
  gather(run);
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
