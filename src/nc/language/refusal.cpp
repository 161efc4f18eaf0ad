#include "nc/language/refusal.hpp"

#include <algorithm>
#include <utility>

#include "base/diagnostic.hpp"

namespace plumbline::nc {

Place place_in(const Block& block, Span span) {
  Place place;
  place.file = block.file;
  place.line = block.line;
  place.text = block.text;
  place.column = std::size_t{span.begin} + 1;
  for (std::size_t end = place.text.find('\n'); end < place.column - 1; end = place.text.find('\n')) {
    place.text.erase(0, end + 1);  // one of the lines that go on with the block
    place.column -= end + 1;
    ++place.line;
  }
  place.text.erase(std::min(place.text.find('\n'), place.text.size()));
  place.length = std::max<std::size_t>(span.end - span.begin, 1);
  return place;
}

void refuse_at(const Block& block, Span span, std::string_view code, std::string message, std::string help) {
  refuse(code, std::move(message), std::move(help), place_in(block, span));
}

}  // namespace plumbline::nc
