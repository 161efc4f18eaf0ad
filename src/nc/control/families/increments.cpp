// What numbers without a decimal point count.
#include <cmath>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr std::uint32_t kAngles = letter_bit('A') | letter_bit('B') | letter_bit('C');
constexpr std::uint32_t kDirection = letter_bit('I') | letter_bit('J') | letter_bit('K');

std::uint32_t letters_of_lengths(const ControlBehaviour& behaviour) {
  constexpr std::uint32_t kLengths = letter_bit('X') | letter_bit('Y') | letter_bit('Z') | letter_bit('U') |
                                     letter_bit('V') | letter_bit('W') | letter_bit('I') | letter_bit('J') |
                                     letter_bit('K') | letter_bit('R');
  return behaviour.fanuc_cycles ? kLengths | letter_bit('Q') : kLengths;
}

[[noreturn]] void refuse_increment(const Execution& run, const Word& word) {
  run.refuse(word, codes::kValueUnknown,
             fmt::format("where this control counts {} mm, it counts numbers with a point so as well, and how far it "
                         "does is not known",
                         to_decimal(*run.settings.input_increment)),
             "set the unit of the control to 1 mm, let the CAM system write for that, and leave out --input-increment");
}

double increment_ratio(const Execution& run) {
  const double increment = run.dialect.behaviour.increment_mm;
  return run.settings.input_increment.value_or(increment) / increment;
}

template <class Take>
void for_each_g_row(const Execution& run, const Block& block, const Take& take) {
  for (const Word& word : block.words) {
    if (word.letter != 'G') continue;
    if (const CodeRow* const row = run.dialect.row_of(word)) take(*row);
  }
}

// That of the block itself counts: the mode acts before F.
FeedMode feed_mode_of(const Execution& run, const Block& block) {
  FeedMode mode = run.control.modal.feed_mode;
  for_each_g_row(run, block, [&](const CodeRow& row) {
    if (row.action == Action::inverse_time) mode = FeedMode::inverse_time;
    if (row.action == Action::per_minute) mode = FeedMode::per_minute;
    if (row.action == Action::per_revolution) mode = FeedMode::per_revolution;
  });
  return mode;
}

void count_feed(const Execution& run, FeedMode mode, Word& word) {
  const ControlBehaviour& behaviour = run.dialect.behaviour;
  if (mode == FeedMode::inverse_time) {
    if (behaviour.inverse_time_increment > 0) word.value *= behaviour.inverse_time_increment;
    return;
  }
  if (behaviour.feed_inch_increment_unknown && run.control.modal.inches && word.value != 0) {
    run.refuse(word, codes::kValueUnknown, "what F without a decimal point counts in inches is not known",
               "write F with a decimal point, or say --calculator-type on");
  }
  const bool turns = mode == FeedMode::per_revolution && behaviour.feed_per_revolution_increment > 0;
  if (turns) word.value *= behaviour.feed_per_revolution_increment;
}

// Degrees of a turn, seconds of a dwell: thousandths in inches, too.
void count_angle(const Execution& run, Word& word) {
  if (word.point || word.expression != kLiteral || run.settings.calculator_type.value_or(false)) return;
  word.value *= increment_ratio(run) * run.dialect.behaviour.increment_deg;
}

// What a number without a decimal point counts, where that is not a unit.
void count_increments(const Execution& run, FeedMode mode, Word& word) {
  const ControlBehaviour& behaviour = run.dialect.behaviour;
  const std::uint32_t letter = letter_bit(word.letter);
  const bool is_length = (letter & letters_of_lengths(behaviour)) != 0;
  const bool is_angle = (letter & kAngles) != 0;
  const double ratio = increment_ratio(run);
  if (ratio != 1 && behaviour.increment_of_rest_unknown && (word.letter == 'F' || is_length || is_angle)) {
    refuse_increment(run, word);
  }
  if (word.point || run.settings.calculator_type.value_or(false) || word.expression != kLiteral) return;
  if (is_length) {
    word.value *= ratio * (run.control.modal.inches ? behaviour.increment_inch : behaviour.increment_mm);
  } else if (is_angle) {
    word.value *= ratio * behaviour.increment_deg;
  } else if (word.letter == 'F') {
    count_feed(run, mode, word);
  }
}

// More decimals than the control keeps; what an increment made of them adds up to differs between series.
void keep_increment(const Execution& run, Word& word) {
  const ControlBehaviour& behaviour = run.dialect.behaviour;
  if (!behaviour.keeps_increment) return;
  const std::optional<Axis> axis = axis_of(word.letter);
  const bool of_a_move = (letter_bit(word.letter) & (letters_of_lengths(behaviour) | kAngles)) != 0;
  if (!axis && !of_a_move) return;
  const double ratio = increment_ratio(run);
  const Kept kept = kept_of(behaviour, axis && is_rotary(*axis), run.control.modal.inches, ratio);
  word.value = kept_value(word.value, kept, word.expression == kLiteral);
}

// An argument without a point counts the increments of its address, which differ between controls [B-63684EN p. 278].
void check_argument(const Execution& run, const Word& word) {
  const bool open = word.letter == 'Q' || word.letter == 'E';
  if (!open || word.point || word.expression != kLiteral || word.value == 0) return;
  if (run.settings.calculator_type.value_or(false)) return;
  run.refuse(word, codes::kValueUnknown,
             fmt::format("what {} without a decimal point passes to a macro differs between controls",
                         run.block->at(word.span)),
             "write it with a decimal point");
}

// S[1000.4] is S1000: what a Fanuc works out for a whole number is rounded [cncarea.com on whole numbers].
void round_speed(const Execution& run, Word& word) {
  const bool whole = run.dialect.behaviour.whole_words.find('S') != std::string::npos;
  const bool rounds = run.dialect.syntax.statements == Statements::macro_b;
  if (whole && rounds && word.expression != kLiteral) word.value = std::round(word.value);
}

bool has_code(const Execution& run, const Block& block, Action action) {
  bool has = false;
  for_each_g_row(run, block, [&](const CodeRow& row) { has = has || row.action == action; });
  return has;
}

// A cycle goes on or begins: K is its count then.
bool is_in_cycle(const Execution& run, const Block& block) {
  const CodeRow* motion = run.control.motion_row;
  for_each_g_row(run, block, [&](const CodeRow& row) {
    if (row.group == 1) motion = &row;
  });
  return motion != nullptr && motion->action == Action::cycle;
}

}  // namespace

void count_increments(const Execution& run, Block& block) {
  const bool has_count = find_word(block, 'K') != nullptr || find_word(block, 'Q') != nullptr;
  const bool in_cycle = has_count && is_in_cycle(run, block);
  const bool turns = find_word(block, 'R') != nullptr && has_code(run, block, Action::turn_on);
  const bool waits = find_word(block, 'X') != nullptr && has_code(run, block, Action::dwell);
  const bool is_call = has_code(run, block, Action::call_macro);
  const FeedMode mode = feed_mode_of(run, block);
  for (Word& word : block.words) {
    if (is_call) check_argument(run, word);
    if (!is_call && word.letter == 'S') round_speed(run, word);
    if (is_code(word) || (in_cycle && word.letter == 'K') || (!in_cycle && word.letter == 'Q')) continue;
    const bool is_direction = !is_call && run.control.tool_vectors && (letter_bit(word.letter) & kDirection) != 0;
    if (is_direction) continue;                                            // no lengths
    if ((turns && word.letter == 'R') || (waits && word.letter == 'X')) {  // degrees, seconds
      count_angle(run, word);
      continue;
    }
    count_increments(run, mode, word);
    if (!waits && !is_call) keep_increment(run, word);  // a macro has what it is given
  }
}

// What the control leaves away of each increment adds up: where the axis ends then is known to nobody.
void check_digits_of_increment(const Execution& run, const Word& word, Axis axis) {
  constexpr double kOfQuantum = 1e-6;
  constexpr double kOfNumber = 1e-12;
  if (!run.dialect.behaviour.increment_word_always) return;
  const Kept kept = kept_of_axis_word(run.dialect.behaviour, is_rotary(axis), run.control.modal.inches, 1, true);
  const double quanta = word.value / kept.quantum;
  if (std::abs(quanta - std::round(quanta)) <= kOfQuantum + kOfNumber * std::abs(quanta)) return;
  run.refuse(word, codes::kNotInterpreted,
             fmt::format("{} is finer than the {} {} that the control keeps, and what becomes of the rest "
                         "was found in no source",
                         run.text_of(word), kept.quantum, is_rotary(axis) ? "deg" : "mm"),
             counts_increments(run)
                 ? fmt::format("write it with {} decimals; in a sum of increments carry the rest on", kept.decimals)
                 : fmt::format("write it with {} decimals; what is worked out as {}=ROUND[VC1*1000]/1000",
                               kept.decimals, word.letter));
}

// In a statement ROUND gives whole numbers, in the value of an axis word what the control keeps of it [H, macros, notes
// on functions].
Rounding rounding_of(const Execution& run, const Block& block, const Word& word) {
  const ControlBehaviour& behaviour = run.dialect.behaviour;
  if (!behaviour.round_keeps_increment || behaviour.whole_words.find(word.letter) != std::string::npos) return {};
  const std::uint32_t letter = letter_bit(word.letter);
  const bool angle = (letter & kAngles) != 0;
  const bool inches = run.control.modal.inches;
  const bool of_another = has_code(run, block, Action::call_macro) ||
                          (inches && (has_code(run, block, Action::turn_on) || has_code(run, block, Action::dwell))) ||
                          (run.control.tool_vectors && (letter & kDirection) != 0);
  if (of_another || (!angle && (letter & letters_of_lengths(behaviour)) == 0)) return {1, false};
  return {kept_of(behaviour, angle, inches, increment_ratio(run)).quantum, true};
}

}  // namespace plumbline::nc
