#include "compensate/stamp_mark.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
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

constexpr std::string_view kTimeTolerance = "timetolerance";

constexpr std::size_t kHead = std::size_t{1} << 16U;
constexpr std::size_t kChunk = std::size_t{1} << 18U;

// Where the first comment of a text begins; its end if it holds none.
std::size_t first_comment(std::string_view text) {
  const std::size_t bracket = std::min(text.find('('), text.size());
  return std::min(text.substr(0, bracket).find(';'), bracket);
}

// Where the line of the first comment begins; the end of the file if it holds none.
std::uint64_t first_commented_line(const InputFile& file) {
  std::vector<char> chunk(kChunk);
  std::uint64_t line = 0;
  for (std::uint64_t offset = 0;;) {
    const std::size_t got = file.read(offset, chunk.data(), chunk.size());
    if (got == 0) return offset;
    const std::string_view text(chunk.data(), got);
    const std::size_t comment = first_comment(text);
    const std::size_t newline = text.substr(0, comment).rfind('\n');
    if (newline != std::string_view::npos) line = offset + newline + 1;
    if (comment < got) return line;
    offset += got;
  }
}

std::size_t lines_before(const InputFile& file, std::uint64_t end) {
  std::vector<char> chunk(kChunk);
  std::size_t lines = 0;
  for (std::uint64_t offset = 0; offset < end;) {
    const std::size_t got = file.read(offset, chunk.data(), std::min<std::uint64_t>(chunk.size(), end - offset));
    if (got == 0) break;
    lines += static_cast<std::size_t>(std::count(chunk.data(), chunk.data() + got, '\n'));
    offset += got;
  }
  return lines;
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

// Where the mark stands, if it does.
std::optional<Place> find_stamp(const InputFile& file) {
  nc::LineSource lines(file);
  const std::uint64_t first = first_commented_line(file);
  lines.seek({first, 1});
  std::string plain;
  for (nc::Line line; lines.next(line);) {
    if (!is_stamp(line.text, plain)) continue;
    Place place;
    place.file = file.name();
    place.line = lines_before(file, first) + line.place.line;
    place.column = line.text.find_first_of("(;") + 1;
    place.length = line.text.size() - place.column + 1;
    place.text = line.text;
    return place;
  }
  return std::nullopt;
}

void refuse_stamped(const InputFile& file) {
  if (std::optional<Place> place = find_stamp(file)) {
    refuse("compensate-stamped", "this program was compensated already", "compensate the original program instead",
           std::move(*place));
  }
}

}  // namespace

bool is_compensated(const InputFile& file) { return find_stamp(file).has_value(); }

std::optional<double> stamped_time_tolerance(const InputFile& file) {
  std::vector<char> head(kHead);
  head.resize(file.read(0, head.data(), head.size()));
  // Signs of comments, and of comments that go on with the text of the one before, are left out with the blanks.
  std::string plain;
  for (const char c : head) {
    if (is_letter(c) || is_digit(c) || c == '.' || c == '-') plain += lower(c);
    if (plain.ends_with("..")) plain.resize(plain.size() - 2);
  }
  const std::size_t mark = plain.find(kMark);
  const std::size_t key = mark != std::string::npos ? plain.find(kTimeTolerance, mark) : mark;
  if (key == std::string::npos) return std::nullopt;
  double share = 0;
  const char* const begin = plain.data() + key + kTimeTolerance.size();
  const auto [end, error] = std::from_chars(begin, plain.data() + plain.size(), share);
  return error == std::errc() && share >= 0 && share <= 1 ? std::optional(share) : std::nullopt;
}

void StampSearch::look_at_program() const { refuse_stamped(program_); }

void StampSearch::look_at(std::string_view file) {
  if (file == program_.name() || seen_.contains(file)) return;
  seen_.emplace(file);
  refuse_stamped(InputFile(std::string(file)));
}

}  // namespace plumbline::compensate
