// What stands in a summary of two columns after a name.
#pragma once

#include <string>
#include <string_view>

namespace plumbline::testing {

/// The figure of the row `name` of a text as report::TextTable writes it; empty if there is no such row.
inline std::string summary_row(const std::string& text, std::string_view name) {
  constexpr std::size_t kFigures = 24;  // where they begin
  std::string begin = "  " + std::string(name);
  begin.resize(kFigures, ' ');
  std::size_t at = text.starts_with(begin) ? 0 : text.find("\n" + begin);
  if (at == std::string::npos) return "";
  if (at > 0) ++at;
  return text.substr(at + kFigures, text.find('\n', at) - at - kFigures);
}

}  // namespace plumbline::testing
