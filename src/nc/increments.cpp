// What numbers without a decimal point count.
#include <fmt/format.h>

#include "base/number_text.hpp"
#include "nc/codes.hpp"
#include "nc/execution.hpp"
#include "nc/expression.hpp"

namespace plumbline::nc {
namespace {

constexpr std::uint32_t kAngles = letter_bit('A') | letter_bit('B') | letter_bit('C');

std::uint32_t letters_of_lengths(const Habits& habits) {
  constexpr std::uint32_t kLengths = letter_bit('X') | letter_bit('Y') | letter_bit('Z') | letter_bit('U') |
                                     letter_bit('V') | letter_bit('W') | letter_bit('I') | letter_bit('J') |
                                     letter_bit('K') | letter_bit('R');
  return habits.fanuc_cycles ? kLengths | letter_bit('Q') : kLengths;
}

[[noreturn]] void refuse_increment(const Execution& run, const Word& word) {
  run.refuse(word, codes::kValueUnknown,
             fmt::format("where this control counts {} mm, it counts numbers with a point so as well, and how far it "
                         "does is not known",
                         to_decimal(*run.settings.input_increment)),
             "set the unit of the control to 1 mm, let the CAM system write for that, and leave out --input-increment");
}

// What a number without a decimal point counts, where that is not a unit.
void count_increments(const Execution& run, Word& word) {
  const Habits& habits = run.dialect.habits;
  const std::uint32_t letter = letter_bit(word.letter);
  const bool is_length = (letter & letters_of_lengths(habits)) != 0;
  const bool is_angle = (letter & kAngles) != 0;
  const double ratio = run.settings.input_increment.value_or(habits.increment_mm) / habits.increment_mm;
  if (ratio != 1 && habits.increment_of_rest_unknown && (word.letter == 'F' || is_length || is_angle)) {
    refuse_increment(run, word);
  }
  if (word.point || run.settings.calculator_type.value_or(false) || word.expression != kLiteral) return;
  if (is_length) {
    word.value *= ratio * (run.control.modal.inches ? habits.increment_inch : habits.increment_mm);
  } else if (is_angle) {
    word.value *= ratio * habits.increment_deg;
  } else if (word.letter == 'F' && run.control.modal.feed_mode == FeedMode::per_revolution &&
             habits.feed_per_revolution_increment > 0) {
    word.value *= habits.feed_per_revolution_increment;
  }
}

// A cycle goes on or begins: K is its count then.
bool is_in_cycle(const Execution& run, const Block& block) {
  const CodeRow* motion = run.control.motion_row;
  for (const Word& word : block.words) {
    const CodeRow* const row = word.letter == 'G' ? run.dialect.row_of(word) : nullptr;
    if (row != nullptr && row->group == 1) motion = row;
  }
  return motion != nullptr && motion->action == Action::cycle;
}

}  // namespace

void count_increments(const Execution& run, Block& block) {
  const bool in_cycle = find_word(block, 'K') != nullptr && is_in_cycle(run, block);
  for (Word& word : block.words) {
    if (in_cycle && word.letter == 'K') continue;
    if (!is_code(word)) count_increments(run, word);
  }
}

}  // namespace plumbline::nc
