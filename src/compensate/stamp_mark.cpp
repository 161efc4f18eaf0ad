#include "compensate/stamp_mark.hpp"

#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::compensate {
namespace {

// As the stamp says it, in small letters and without blanks.
constexpr std::string_view kProgram = "plumbline";
constexpr std::string_view kMark = "compensatedthisprogram";

bool begins_comment(char c) { return c == '(' || c == ';'; }

bool is_stamp(std::string_view line, std::string& plain) {
  std::size_t at = 0;
  while (at < line.size() && !begins_comment(line[at])) ++at;
  if (line.size() - at <= kProgram.size() + kMark.size()) return false;
  plain.clear();
  for (const char c : line.substr(at)) {
    if (c != ' ' && c != '\t' && c != '\r') plain += lower(c);
  }
  const std::size_t program = plain.find(kProgram);
  return program != std::string::npos && plain.find(kMark, program) != std::string::npos;
}

void refuse_stamped(const InputFile& file) {
  nc::LineSource lines(file);
  std::string plain;
  for (nc::Line line; lines.next(line);) {
    if (!is_stamp(line.text, plain)) continue;
    Place place;
    place.file = file.name();
    place.line = line.place.line;
    place.column = line.text.find_first_of("(;") + 1;
    place.length = line.text.size() - place.column + 1;
    place.text = line.text;
    refuse("compensate-stamped", "this program was compensated already", "compensate the original program instead",
           std::move(place));
  }
}

}  // namespace

void StampSearch::look_at_program() const { refuse_stamped(program_); }

void StampSearch::look_at(std::string_view file) {
  if (file == program_.name() || seen_.contains(file)) return;
  seen_.emplace(file);
  refuse_stamped(InputFile(std::string(file)));
}

}  // namespace plumbline::compensate
