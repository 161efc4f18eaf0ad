#include "nc/sequence/flow_block.hpp"

#include <algorithm>
#include <utility>

#include "nc/control/parameters/expression.hpp"
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

int number_of(Interpreter& interpreter, const Block& block, std::uint32_t code, std::string_view what) {
  return whole_number(block, block.flow.span, interpreter.value_of(block, code, block.flow.span), what);
}

}  // namespace plumbline::nc
