#include "nc/sequence/flow_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "nc/control/parameters/expression.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {

Span steering_span(const Block& block) {
  const bool is_word = block.flow.word == FlowWord::none && !block.words.empty();
  return is_word ? block.words.front().span : block.flow.span;
}

Place steering_place(const Block& block) {
  const Span span = steering_span(block);
  Place place;
  place.file = block.file;
  place.line = block.line;
  place.column = std::size_t{span.begin} + 1;
  place.length = std::max<std::size_t>(span.end - span.begin, 1);
  place.text = block.text;
  return place;
}

void refuse_flow(const Block& block, std::string_view code, std::string message, std::string help) {
  refuse_at(block, steering_span(block), code, std::move(message), std::move(help));
}

bool condition_holds(Interpreter& interpreter, const Block& block) {
  return interpreter.value_of(block, block.flow.values.front(), block.flow.span) != 0;
}

double chosen_by(Interpreter& interpreter, const Block& block, std::uint32_t code) {
  const double value = interpreter.value_of(block, code, block.flow.span);
  if (value == std::trunc(value)) return value;
  refuse_flow(block, codes::kNotWhole, fmt::format("CASE chooses by {}, which is no whole number", value),
              "choose by whole numbers, as ROUND makes them, or by IF");
}

int number_of(Interpreter& interpreter, const Block& block, std::uint32_t code, std::string_view what) {
  return whole_number(block, block.flow.span, interpreter.value_of(block, code, block.flow.span), what);
}

// "N0 must not be used" [B-63684EN p. 129], and GOTO 0 is an alarm.
std::string block_name(const Block& block, int number) {
  if (number < 1) {
    refuse_flow(block, codes::kOutOfRange, fmt::format("there is no block N{} to go on at", number),
                "blocks have the numbers 1 to 99999: give that block another one");
  }
  return fmt::format("N{}", number);
}

}  // namespace plumbline::nc
