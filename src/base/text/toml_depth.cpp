#include "base/text/toml_depth.hpp"

#include <algorithm>

namespace plumbline {
namespace {

// What a text of several lines stands between.
std::string_view long_quote(char quote) { return quote == '"' ? R"(""")" : "'''"; }

// Three quotes that end a text may have up to two of its own before them.
std::size_t end_of_long_text(std::string_view text, std::size_t at, char quote) {
  for (; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text.substr(at).starts_with(long_quote(quote))) {
      at += 3;
      for (int own = 0; own < 2 && at < text.size() && text[at] == quote; ++own) ++at;
      return at;
    }
  }
  return at;
}

// The offset after a text in quotes that begins at `at`.
std::size_t end_of_text(std::string_view text, std::size_t at) {
  const char quote = text[at];
  if (text.substr(at).starts_with(long_quote(quote))) return end_of_long_text(text, at + 3, quote);
  for (++at; at < text.size() && text[at] != quote && text[at] != '\n'; ++at) {
    if (quote == '"' && text[at] == '\\') ++at;
  }
  return at + 1;
}

}  // namespace

std::optional<std::size_t> too_deep(std::string_view text, std::size_t most) {
  std::size_t points = 0;
  std::size_t brackets = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_text(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.') {
      ++points;
    } else if (c == '[' || c == '{') {
      ++brackets;
      points = 0;
    } else if (c == ']' || c == '}') {
      brackets -= brackets > 0 ? 1 : 0;
      points = 0;
    } else if (c == '=' || c == ',' || c == '\n') {
      points = 0;
    }
    if (points > most || brackets > most) return at;
    ++at;
  }
  return std::nullopt;
}

}  // namespace plumbline
