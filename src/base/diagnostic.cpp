#include "base/diagnostic.hpp"

#include <algorithm>

#include <fmt/format.h>

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

// The line under a caret; tabs and control characters become blanks so that the caret stands where it should.
std::string excerpt(const Place& place) {
  const std::size_t column = std::max<std::size_t>(place.column, 1);
  std::size_t first = 0;
  if (place.text.size() > kShownWidth && column > kShownWidth / 2) first = column - kShownWidth / 2;
  std::string shown = place.text.substr(std::min(first, place.text.size()), kShownWidth);
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  const std::size_t at = column - 1 - first;
  const std::size_t room = shown.size() > at ? shown.size() - at : 1;
  const std::size_t marks = std::clamp<std::size_t>(place.length, 1, room);
  const std::string number = fmt::format("{:>5}", place.line);
  return fmt::format("{} | {}\n      | {}^{}\n", number, shown, std::string(at, ' '), std::string(marks - 1, '~'));
}

}  // namespace

std::string to_text(const Diagnostic& d) {
  std::string out;
  if (!d.place.file.empty()) out += d.place.file + ":";
  if (d.place.line > 0) out += fmt::format("{}:", d.place.line);
  if (d.place.line > 0 && d.place.column > 0) out += fmt::format("{}:", d.place.column);
  if (!out.empty()) out += ' ';
  out += fmt::format("{}: {}", name_of(d.severity), d.message);
  out += d.code.empty() ? "\n" : fmt::format(" [{}]\n", d.code);
  if (d.place.line > 0 && d.place.column > 0) out += excerpt(d.place);
  if (!d.help.empty()) out += fmt::format("help: {}\n", d.help);
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
  return place;
}

}  // namespace plumbline
