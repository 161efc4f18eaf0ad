#include "compensate/stamp_mark.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::compensate {
namespace {

// As the stamp says it, in small letters and without blanks.
constexpr std::string_view kProgram = "plumbline";
constexpr std::string_view kMark = "compensatedthisprogram";

constexpr std::size_t kChunk = std::size_t{1} << 18U;

// Where the first comment of a text begins; its end if it holds none.
std::size_t first_comment(std::string_view text) {
  const std::size_t bracket = std::min(text.find('('), text.size());
  return std::min(text.substr(0, bracket).find(';'), bracket);
}

// The line of the first comment; the end of the file if it holds none.
nc::LinePlace first_commented_line(const InputFile& file) {
  std::vector<char> chunk(kChunk);
  nc::LinePlace line;
  for (std::uint64_t offset = 0;;) {
    const std::size_t got = file.read(offset, chunk.data(), chunk.size());
    const std::string_view text(chunk.data(), got);
    const std::size_t comment = first_comment(text);
    const std::string_view before = text.substr(0, comment);
    const std::size_t newline = before.rfind('\n');
    if (newline != std::string_view::npos) {
      line.line += static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
      line.offset = offset + newline + 1;
    }
    if (comment < got || got == 0) return line;
    offset += got;
  }
}

bool is_stamp(std::string_view line, std::string& plain) {
  const std::size_t at = first_comment(line);
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
  lines.seek(first_commented_line(file));
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
