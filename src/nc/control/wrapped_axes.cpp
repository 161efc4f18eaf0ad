// Words of axes that turn without end, where they count within a turn and their sign says the way round.
#include <cmath>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/rotary.hpp"

namespace plumbline::nc {

void check_within_turn(const Execution& run, const Word& word) {
  if (std::abs(word.value) < kFullTurn) return;
  run.refuse(word, codes::kOutOfRange, fmt::format("{} is a turn or more", run.block->at(word.span)),
             "on an axis whose words have a sign for the way round (--rotary), write 0 to 359.999, or use G91");
}

bool is_wrapped(const Execution& run, Axis axis) {
  return is_rotary(axis) && run.control.modal.rule_of(axis) == RotaryRule::sign &&
         run.dialect.syntax.system_variables == SystemVariables::rs274;
}

void check_wrapped_words(const Execution& run) {
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis) && is_wrapped(run, axis)) check_within_turn(run, *run.words.find(axis));
  }
}

void check_sign_of_zero(const Execution& run, const Word& word, Axis axis) {
  if (run.control.modal.rule_of(axis) != RotaryRule::sign || run.dialect.behaviour.zero_has_sign) return;
  const std::string_view text = run.block->at(word.span);
  const std::size_t value = text.find_first_not_of(" \t=", 1);
  if (run.value(axis) != 0 || value == std::string_view::npos || text[value] != '-') return;
  run.refuse(word, codes::kNotInterpreted,
             fmt::format("the sign of {} says which way round the axis turns, and whether the control keeps that of 0 "
                         "was found in no source",
                         text),
             fmt::format("write {}0 where it turns upwards, or turn it by increments (G91)", word.letter));
}

// C5.3 where C stands at 5.3: the control compares the two as they are, and what rounding left of one of them is a
// whole turn there [interp_find.cc, unwrap_rotary].
void check_stands_there(const Execution& run, const Word& word, Axis axis, double from) {
  constexpr double kSameAngle = 1e-9;  // deg
  const double place = std::abs(word.value) + std::floor(from / kFullTurn) * kFullTurn;
  if (place == from && !run.control.shifted.contains(axis)) return;
  if (std::abs(std::remainder(place - from, kFullTurn)) > kSameAngle) return;
  run.refuse(word, codes::kNotInterpreted,
             fmt::format("{} stands there already but for what rounding leaves, by which the control may turn it all "
                         "the way round",
                         letter(axis)),
             "leave the word out, or turn the axis by increments (G91)");
}

}  // namespace plumbline::nc
