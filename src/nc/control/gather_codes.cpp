// Which codes a block holds, each with its row, and its other words; whether they go together.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kCodeTolerance = 1e-3;  // of ten times a G code [LinuxCNC, measured]
constexpr int kUserGroup = 63;
constexpr std::uint32_t kUninterpretedLetters = letter_bit('U') | letter_bit('V') | letter_bit('W');
constexpr double kLargestValue = 1e9;  // so that sums of them can be written with all that a double holds of them

[[noreturn]] void refuse_row(const Execution& run, const CodeRow& row, const Word& word) {
  std::string help(kWriteItOut);
  if (word.letter == 'M') {
    help = fmt::format("leave it out, or, if it moves nothing on this machine, let it through: --pass {}",
                       run.text_of(word));
  }
  if (const std::string_view way_out = row.way_out(); !way_out.empty()) help = way_out;
  run.refuse(word, codes::kNotInterpreted, fmt::format("{} {}", run.text_of(word), row.reason()), std::move(help));
}

// G1.0, M3.: of controls but LinuxCNC's none is known to read them, and no post writes them.
void check_no_point(const Execution& run, const Word& word) {
  const bool needless = word.expression == kLiteral && word.point && word.value == std::round(word.value);
  if (!needless || run.dialect.syntax.statements == Statements::o_words) return;
  run.refuse(word, codes::kNotWhole,
             fmt::format("{} has a point, and the number of a code is written without one", run.text_of(word)),
             fmt::format("write {}{:.0f}", word.letter, word.value));
}

bool counts_in_g20_g21(const Dialect& dialect) {
  const CodeRow* const inch = dialect.g_code(200);
  return inch != nullptr && inch->action == Action::inches;
}

const CodeRow* g_row(const Execution& run, const Word& word) {
  check_no_point(run, word);
  const double times_ten = word.value * 10;
  const double whole = std::round(times_ten);
  const CodeRow* row = nullptr;
  if (std::abs(times_ten - whole) < kCodeTolerance && whole >= 0 && whole < 1e4) {
    row = run.dialect.g_code(static_cast<int>(whole));
  }
  if (row == nullptr) {
    const bool units_of_iso = whole == 700 || whole == 710;  // 6983
    run.refuse(word, codes::kUnknownCode, fmt::format("{} is no G code of this control", run.text_of(word)),
               units_of_iso && counts_in_g20_g21(run.dialect)
                   ? "units are G20 (inch) and G21 (mm) here: set them in the post-processor"
                   : "look for a slip, or choose another dialect");
  }
  if (row->action == Action::compensation_on) {
    run.refuse(word, codes::kNotInterpreted,
               fmt::format("{} lets the control offset the path by the tool's radius", run.text_of(word)),
               "let the CAM system write the path of the tool's centre: an offset at the control would turn the "
               "corrections of the path into others");
  }
  if (row->action == Action::refused) refuse_row(run, *row, word);
  return row;
}

const CodeRow* m_row(const Execution& run, const Word& word) {
  check_no_point(run, word);
  const int code = whole_number(*run.block, word.span, word.value, "an M code");
  const CodeRow* row = code < 0 || code > 1000 ? nullptr : run.dialect.m_code(code * 10);
  if (row != nullptr && row->action != Action::refused) return row;
  if (row != nullptr && !run.settings.passed_m_codes.contains(code)) refuse_row(run, *row, word);
  const bool users = code >= run.dialect.first_user_m_code && code <= run.dialect.last_user_m_code;
  if (run.settings.passed_m_codes.contains(code) || (users && run.settings.as_with_empty_tables)) {
    return &run.dialect.user_row;
  }
  if (!users) {
    run.refuse(
        word, codes::kUnknownCode, fmt::format("{} is no M code of this control", run.text_of(word)),
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

// Some controls read each axis by the code before it, others all of them by the last one.
void check_both_distances(const Execution& run) {
  if (run.axes.empty() && !run.words.has('R')) return;
  const Chosen* first = nullptr;
  for (const Chosen& chosen : run.chosen) {
    if (chosen.row->action != Action::absolute && chosen.row->action != Action::incremental) continue;
    if (first != nullptr && first->row != chosen.row) {
      run.refuse(*chosen.word, codes::kNotInterpreted,
                 fmt::format("which axes {} and {} count for in one block differs between controls",
                             run.text_of(*first->word), run.text_of(*chosen.word)),
                 "put one of them into a block of its own, as in G91 G28 Z0, then G90");
    }
    first = &chosen;
  }
}

// Two codes of one modal group cannot both act.
void check_groups(Execution& run) {
  if (run.dialect.behaviour.last_of_group) {
    check_cycle_beside_motion(run);
    check_both_distances(run);
    return keep_last_of_groups(run);
  }
  std::uint64_t seen_g = 0;
  std::uint64_t seen_m = 0;
  for (const Chosen& chosen : run.chosen) {
    if (!is_code(*chosen.word)) continue;
    if (chosen.row->group < 0 || chosen.row->action == Action::motion_off)
      continue;  // gives way to another motion [LinuxCNC, measured]
    const bool users = chosen.row == &run.dialect.user_row;
    if (users && run.dialect.syntax.statements != Statements::o_words) continue;  // of the builder, who may group them
    const int group = users ? kUserGroup : chosen.row->group;
    std::uint64_t& seen = chosen.word->letter == 'M' ? seen_m : seen_g;
    if ((seen >> static_cast<unsigned>(group) & 1U) != 0) {
      run.refuse(*chosen.word, codes::kSameGroup,
                 fmt::format("{} contradicts another code of its modal group in this block", run.text_of(*chosen.word)),
                 "put them into blocks of their own");
    }
    seen |= std::uint64_t{1} << static_cast<unsigned>(group);
  }
}

// @ and ^ stand for X and Y.
void take_polar(Execution& run) {
  if (run.control.modal.plane != Plane::xy) {  // the one before the block [LinuxCNC, measured]
    run.refuse(polar_word(run), codes::kOutOfRange, "polar words need the XY plane before their block",
               "write G17 into a block of its own before, or X, Y and Z");
  }
  const AxisSet plane{Axis::X, Axis::Y};
  for (const Axis axis : {Axis::X, Axis::Y}) {
    if (!run.axes.contains(axis)) continue;
    run.refuse(*run.words.find(axis), codes::kAxesTwice, "the end is given by @ and ^ as well",
               "give either X and Y or radius and angle");
  }
  run.axes = run.axes | plane;
  run.step.end_words = EndWords::polar;
}

// F and S of a dwell are its time, not a feed and a speed; G131 has an F of its own.
void take_words_of_dwell(Execution& run) {
  std::uint32_t of_dwell = 0;
  for (const Chosen& chosen : run.chosen) {
    const Action action = chosen.row->action;
    if (action == Action::dwell || action == Action::no_motion) of_dwell |= chosen.row->word_mask;
  }
  std::erase_if(run.chosen, [&](const Chosen& chosen) {
    return (chosen.word->letter == 'F' || chosen.word->letter == 'S') &&
           (letter_bit(chosen.word->letter) & of_dwell) != 0;
  });
}

void refuse_twice(const Execution& run, const Word& word) {
  run.refuse(word, codes::kWordTwice, fmt::format("two {} words in one block", word.letter), "leave one of them");
}

// AC and IC are of axes and of points of a circle, the others of axes that turn [N p. 143, p. 149].
void check_word_mode(const Execution& run, const Word& word) {
  const std::optional<Axis> axis = axis_of(word.letter);
  const bool of_point = std::string_view("IJK123").find(word.letter) != std::string_view::npos;
  const bool straight = word.mode == WordMode::absolute || word.mode == WordMode::incremental;
  if (word.use == WordUse::tool_vector || (straight && (axis || of_point))) return;
  if (!straight && axis && is_rotary(*axis)) return;
  run.refuse(word, codes::kNotInterpreted,
             straight
                 ? fmt::format("{} is no word of an axis or of a point, and what it counts from was found in no "
                               "source",
                               run.text_of(word))
                 : fmt::format("{} says which way round an axis turns, and this is no such axis", run.text_of(word)),
             straight ? "write the value itself" : "write the value itself; DC, ACP and ACN are of A, B and C");
}

// Only an axis that turns without end has a shorter or a positive way round; G90 counts within its turn then (setting).
void take_word_mode(Execution& run, const Word& word) {
  check_word_mode(run, word);
  run.has_word_modes = true;
  const std::optional<Axis> axis = axis_of(word.letter);
  if (word.mode == WordMode::absolute || word.mode == WordMode::incremental || !axis || !is_rotary(*axis)) return;
  RotaryRule& rule = run.control.modal.rotary[index(*axis) - 3];
  if (rule == RotaryRule::linear) rule = RotaryRule::one_turn;
}

// G54 P2 is G54.1 P2 where nobody else of the block takes the P.
void take_code_beside(Execution& run) {
  const CodeRow* const mode = run.control.motion_row;
  for (Chosen& code : run.chosen) {
    const std::uint32_t letter = code.row->beside_is == 0 ? 0 : letter_bit(code.row->not_beside);
    if ((run.words.letters() & letter) == 0) continue;
    const bool taken = (mode != nullptr && (mode->word_mask & letter) != 0) ||
                       std::any_of(run.chosen.begin(), run.chosen.end(),
                                   [&](const Chosen& other) { return (other.row->word_mask & letter) != 0; });
    if (!taken) code.row = run.dialect.g_code(code.row->beside_is);
  }
}

[[noreturn]] void refuse_large(const Execution& run, const Word& word) {
  run.refuse(word, codes::kOutOfRange, fmt::format("{} is worth {:.6g}", word.letter, word.value),
             fmt::format("look for a slip or a missing point; words may be worth up to {:.0e}", kLargestValue));
}

// G74 X1=0: a move of struts and carriages to marks of their own.
void check_machine_axis(const Execution& run, const Word& word) {
  const bool takes_axes = std::any_of(run.chosen.begin(), run.chosen.end(),
                                      [](const Chosen& chosen) { return chosen.row->action == Action::lose_position; });
  if (takes_axes) return;
  run.refuse(word, codes::kNotInterpreted, fmt::format("{} moves an axis of the machine itself", run.text_of(word)),
             "write X, Y and Z; axes of the machine stand in a block with G74 or G75");
}

}  // namespace

void gather_codes(Execution& run) {
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
        run.refuse_point(word);
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
  if (run.words.polar()) take_polar(run);
  if (run.chosen.size() > 1) {
    if (run.dialect.behaviour.dwell_takes_words) take_words_of_dwell(run);
    check_groups(run);
  }
  take_code_beside(run);
}

}  // namespace plumbline::nc
