#include "nc/language/linuxcnc_tool_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/tool_limits.hpp"

namespace plumbline::nc {
namespace {

constexpr std::string_view kOffsets = "XYABCUVW";  // that a tool of plumbline's does not have
constexpr std::string_view kOfLathes = "IJQ";
constexpr std::string_view kForm = "write a line a tool, as in T1 P1 D+6.0 Z+85.0 ;end mill";

// Calls `take` with where each line begins and its text without the comment, until it returns false.
template <class Take>
void each_line(std::string_view text, const Take& take) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    line = line.substr(0, line.find(';'));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (line.find_first_not_of(" \t") != std::string_view::npos && !take(begin, line)) return;
    begin = end + 1;
  }
}

struct WordPlace {
  std::size_t offset = 0;
  std::size_t length = 0;
};

class LineReader {
 public:
  LineReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<Tool> read() {
    each_line(text_, [&](std::size_t begin, std::string_view line) {
      read_line(begin, line);
      return true;
    });
    return std::move(tools_);
  }

 private:
  [[noreturn]] void refuse_at(WordPlace span, std::string_view code, std::string message, std::string help) const {
    refuse(code, std::move(message), std::move(help), place_in(file_, text_, span.offset, span.length));
  }

  void read_line(std::size_t begin, std::string_view line) {
    Tool tool;
    std::set<char> letters;
    WordPlace number;
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t word = std::min(line.find_first_not_of(' ', at), line.size());
      const std::size_t end = std::min(line.find(' ', word), line.size());
      if (word == end) break;
      const WordPlace span{begin + word, end - word};
      const char letter = upper(line[word]);
      if (!letters.insert(letter).second)
        refuse_at(span, "tools-value", fmt::format("{} stands twice in this line", letter), "leave one of them");
      if (letter == 'T') number = span;
      take_word(letter, line.substr(word + 1, end - word - 1), span, tool);
      at = end;
    }
    for (const char needed : {'T', 'P'}) {
      if (!letters.contains(needed))
        refuse_at({begin, line.size()}, "tools-value", fmt::format("a tool without {}", needed), std::string(kForm));
    }
    add(tool, number);
  }

  void take_word(char letter, std::string_view digits, WordPlace span, Tool& tool) const {
    const std::optional<double> value = parse_number(digits);
    if (!value) refuse_at(span, "tools-value", "this is no word of a tool", std::string(kForm));
    if (letter == 'T') {
      if (*value < 0 || *value > kLargestToolNumber || *value != std::floor(*value))
        refuse_at(span, "tools-value", "the number of a tool is a whole number", std::string(kForm));
      tool.number = static_cast<int>(*value);
    } else if (letter == 'Z') {
      tool.length_mm = length(*value, span);
    } else if (letter == 'D') {
      if (*value < 0 || *value > kLongestTool)
        refuse_at(span, "tools-value", "the diameter is out of range", fmt::format("write 0 to {} mm", kLongestTool));
      tool.diameter_mm = *value;
    } else if (kOffsets.find(letter) != std::string_view::npos) {
      if (*value != 0) {
        refuse_at(span, "tools-value", fmt::format("a tool with an offset in {} is not interpreted", letter),
                  "set it to 0, and let the work offset hold it");
      }
    } else if (letter != 'P' && kOfLathes.find(letter) == std::string_view::npos) {
      refuse_at(span, "tools-value", "this is no word of a tool", std::string(kForm));
    }
  }

  double length(double value, WordPlace span) const {
    if (value == 0 || (std::abs(value) >= kShortestTool && std::abs(value) <= kLongestTool)) return value;
    refuse_at(span, "tools-value",
              fmt::format("a tool of {} mm is too {}", value, std::abs(value) < 1 ? "short" : "long"),
              "write millimetres, from the gauge point of the spindle; a table in inches is not read");
  }

  void add(const Tool& tool, WordPlace number) {
    if (!seen_.insert(tool.number).second)
      refuse_at(number, "tools-twice", fmt::format("tool {} stands here twice", tool.number), "leave one of them");
    if (tool.number > 0) {
      tools_.push_back(tool);
    } else if (tool.length_mm != 0) {
      refuse_at(number, "tools-value", "T0 is no tool, but has a length", "leave its Z out, or give it a number");
    }
  }

  std::string_view text_;
  const std::string& file_;
  std::vector<Tool> tools_;
  std::set<int> seen_;
};

}  // namespace

bool is_linuxcnc_tool_table(std::string_view text) {
  bool is_one = false;
  each_line(text, [&](std::size_t, std::string_view line) {
    line.remove_prefix(line.find_first_not_of(" \t"));
    constexpr std::string_view kOfTool = "TPZD";
    const bool begins = line.size() > 1 && kOfTool.find(upper(line[0])) != std::string_view::npos;
    is_one = (begins && (is_digit(line[1]) || line[1] == '+' || line[1] == '-')) || upper(line).starts_with("POC ");
    return false;
  });
  return is_one;
}

std::vector<Tool> read_linuxcnc_tool_table(std::string_view text, const std::string& file) {
  return LineReader(text, file).read();
}

}  // namespace plumbline::nc
