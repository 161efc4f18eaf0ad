#include "settings/variables_file.hpp"

#include <string_view>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/text/characters.hpp"
#include "base/text/encoding.hpp"
#include "base/text/number_text.hpp"
#include "nc/control/parameters/parameters.hpp"

namespace plumbline::settings {
namespace {

constexpr int kFirstWorkOffset = 5221;
constexpr int kRotation = 9;  // after the first of a work system
constexpr std::string_view kBlanks = " \t\r";
constexpr std::string_view kForm =
    R"(write "#NUMBER VALUE", as in "#100 12.5"; of R parameters "R5 12.5", of common variables "VC5 12.5")";

struct Piece {
  std::size_t begin = 0;
  std::size_t size = 0;
};

// The next run of bytes that are neither blank nor "=".
Piece next_piece(std::string_view line, std::size_t from) {
  constexpr std::string_view kBetween = " \t\r=";
  const std::size_t begin = std::min(line.find_first_not_of(kBetween, from), line.size());
  const std::size_t end = std::min(line.find_first_of(kBetween, begin), line.size());
  return {begin, end - begin};
}

class VariablesReader {
 public:
  VariablesReader(std::string path, const std::string& text) : path_(std::move(path)), text_(text) {}

  void take_line(std::size_t begin, std::size_t end) {
    std::string_view line = std::string_view(text_).substr(begin, end - begin);
    if (const std::size_t at = lone_carriage_return(line); at != std::string_view::npos) {
      refuse("variables-line", std::string(kLoneCarriageReturn), std::string(kOtherLineEnds),
             place_in(path_, text_, begin + at, 1));
    }
    line = line.substr(0, line.find(';'));
    if (line.find_first_not_of(kBlanks) == std::string_view::npos) return;
    Piece number = next_piece(line, 0);
    const Piece value = next_piece(line, number.begin + number.size);
    const Piece rest = next_piece(line, value.begin + value.size);
    if (value.size == 0) refuse_at(begin, number, "variables-line", "a variable without a value");
    if (rest.size != 0) refuse_at(begin, rest, "variables-line", "a line holds one variable and its value");
    int first = 1;
    if (line[number.begin] == '#' || line[number.begin] == 'R') {
      first = line[number.begin] == 'R' ? 0 : 1;
      ++number.begin, --number.size;
    } else if (line.substr(number.begin).starts_with("VC")) {
      number.begin += 2, number.size -= 2;
    }
    const std::optional<double> index = parse_number(line.substr(number.begin, number.size));
    if (!index || *index < first || *index > nc::kLastParameter || *index != static_cast<int>(*index)) {
      refuse_at(begin, number, "variables-number",
                fmt::format("the number of a variable is a whole one, 1 to {}", nc::kLastParameter));
    }
    const std::optional<double> parsed = parse_number(line.substr(value.begin, value.size));
    if (!parsed) refuse_at(begin, value, "variables-value", "the value of a variable is a number");
    if (!variables_.emplace(static_cast<int>(*index), *parsed).second) {
      refuse_at(begin, number, "variables-twice", fmt::format("#{} has a value already", *index));
    }
  }

  std::map<int, double> take() { return std::move(variables_); }

 private:
  [[noreturn]] void refuse_at(std::size_t line, Piece piece, std::string_view code, std::string message) const {
    refuse(code, std::move(message), std::string(kForm), place_in(path_, text_, line + piece.begin, piece.size));
  }

  std::string path_;
  const std::string& text_;
  std::map<int, double> variables_;
};

constexpr std::size_t kSystemsOfVariables = 9;  // G54 to G59.3, of which other controls have the first six

}  // namespace

std::map<int, double> read_variables(const Source& source) {
  const std::string text = read_text(source);
  refuse_not_text(text, source.name());
  VariablesReader reader(source.name(), text);
  for (std::size_t begin = byte_order_mark_size(text); begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    reader.take_line(begin, end);
    begin = end + 1;
  }
  return reader.take();
}

std::vector<OffsetVariable> offset_variables(int system, const std::map<int, double>& variables) {
  std::vector<OffsetVariable> held;
  if (system < 1 || system > static_cast<int>(kSystemsOfVariables)) return held;
  const int first = kFirstWorkOffset + nc::kParametersPerRow * (system - 1);
  const auto add = [&](int number, std::optional<Axis> axis) {
    if (const auto found = variables.find(number); found != variables.end())
      held.push_back({number, axis, found->second});
  };
  for (const Axis axis : kAllAxes) add(first + static_cast<int>(index(axis)), axis);
  add(first + kRotation, std::nullopt);
  return held;
}

std::array<std::optional<nc::WorkOffset>, nc::kWorkSystems> work_offsets_of(const std::map<int, double>& variables) {
  std::array<std::optional<nc::WorkOffset>, nc::kWorkSystems> systems;
  for (std::size_t i = 0; i < kSystemsOfVariables; ++i) {
    const int first = kFirstWorkOffset + nc::kParametersPerRow * static_cast<int>(i);
    nc::WorkOffset offset;
    bool is_whole = true;
    for (const Axis axis : kAllAxes) {
      const auto found = variables.find(first + static_cast<int>(index(axis)));
      is_whole = is_whole && found != variables.end();
      if (is_whole) offset.origin[axis] = found->second;
    }
    const auto rotation = variables.find(first + kRotation);
    if (rotation != variables.end()) offset.rotation_deg = rotation->second;
    if (is_whole) systems[i] = offset;
  }
  return systems;
}

}  // namespace plumbline::settings
