#include "nc/language/comment_line.hpp"

#include <algorithm>

#include "base/text/characters.hpp"

namespace plumbline::nc {

std::size_t comment_room(const Dialect& dialect) {
  return dialect.line_length -
         std::min(dialect.line_length, dialect.comment_open.size() + dialect.comment_close.size());
}

std::string comment_line(std::string_view text, const Dialect& dialect) {
  const std::string_view fits = text.substr(0, comment_room(dialect));
  return dialect.comment_open + (dialect.syntax.capitals ? upper(fits) : std::string(fits)) + dialect.comment_close;
}

}  // namespace plumbline::nc
