#include "base/diagnostic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text/printable.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kShownWidth = 160;  // a longer line is cut around the caret

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::warning:
      return "warning";
    case Severity::note:
      return "note";
    case Severity::error:
      break;
  }
  return "error";
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }  // UTF-8

std::size_t characters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

// The line with a caret below; a long one is cut around it, between two characters.
std::string excerpt(const Place& place) {
  const std::size_t column = std::max<std::size_t>(place.column, 1);
  std::size_t first = 0;
  if (place.text.size() > kShownWidth && column > kShownWidth / 2) first = column - kShownWidth / 2;
  first = std::min(first, place.text.size());
  while (first > 0 && first < place.text.size() && continues_character(place.text[first])) --first;
  std::size_t end = std::min(first + kShownWidth, place.text.size());
  while (end < place.text.size() && continues_character(place.text[end])) ++end;

  const std::string shown = blanked(place.text.substr(first, end - first));
  const std::string_view before = std::string_view(shown).substr(0, column - 1 - first);
  const std::string_view marked = std::string_view(shown).substr(before.size(), place.length);
  const std::string number = fmt::format("{:>5}", place.line);
  return fmt::format("{} | {}\n{} | {}^{}\n", number, shown, std::string(number.size(), ' '),
                     std::string(characters(before), ' '),
                     std::string(std::max<std::size_t>(characters(marked), 1) - 1, '~'));
}

}  // namespace

std::string to_text(const Diagnostic& d) {
  std::string out;
  if (!d.place.file.empty()) out += printable(d.place.file) + ":";
  if (d.place.line > 0) out += fmt::format("{}:", d.place.line);
  if (d.place.line > 0 && d.place.column > 0) out += fmt::format("{}:", d.place.column);
  if (!out.empty()) out += ' ';
  out += fmt::format("{}: {}", name_of(d.severity), printable(d.message));
  out += d.code.empty() ? "\n" : fmt::format(" [{}]\n", d.code);
  if (d.place.line > 0 && d.place.column > 0) out += excerpt(d.place);
  if (!d.help.empty()) out += fmt::format("help: {}\n", printable_lines(d.help));
  return out;
}

void refuse(std::string_view code, std::string message, std::string help, Place place) {
  throw Refusal({std::string(code), std::move(message), std::move(help), std::move(place), Severity::error});
}

Place place_in(std::string_view file, std::string_view text, std::size_t offset, std::size_t length) {
  offset = std::min(offset, text.size());
  const std::size_t begin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;  // npos + 1 == 0
  const std::size_t end = std::min(text.find('\n', offset), text.size());
  Place place;
  place.file = file;
  place.line =
      1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
  place.column = offset - begin + 1;
  place.length = length;
  place.text = text.substr(begin, end - begin);
  if (!place.text.empty() && place.text.back() == '\r') place.text.pop_back();
  place.column = std::min(place.column, place.text.size() + 1);
  return place;
}

}  // namespace plumbline
