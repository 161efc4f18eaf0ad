#include "jobs/used_tools.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "base/characters.hpp"
#include "nc/line_source.hpp"

namespace plumbline::jobs {
namespace {

constexpr int kLargestNumber = 99999999;

class Scan {
 public:
  void take(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (c == ';') return;
      if (c == '(') i = std::min(line.find(')', i), line.size());
      if (std::string_view("TtHhQq").find(c) == std::string_view::npos) continue;
      std::size_t at = i + 1;
      while (at < line.size() && (is_blank(line[at]) || line[at] == '+')) ++at;
      if (at < line.size() && (line[at] == '#' || line[at] == '[' || line[at] == '=')) has_expression_ = true;
      if (at < line.size() && is_digit(line[at])) take_number(line, at);
    }
  }

  bool may_use(int number) const { return has_expression_ || numbers_.contains(number); }

 private:
  void take_number(std::string_view line, std::size_t at) {
    int number = 0;
    for (; at < line.size() && (is_digit(line[at]) || is_blank(line[at])); ++at) {
      if (is_digit(line[at])) number = std::min(number * 10 + (line[at] - '0'), kLargestNumber / 10);
    }
    numbers_.insert(number);
  }

  bool has_expression_ = false;
  std::set<int> numbers_;
};

}  // namespace

std::vector<nc::Tool> used_tools(const InputFile& program, const nc::ToolTable& tools,
                                 std::optional<int> tool_in_spindle) {
  if (tools.empty()) return {};
  Scan scan;
  nc::LineSource lines(program);
  for (nc::Line line; lines.next(line);) scan.take(line.text);
  std::vector<nc::Tool> used;
  for (const nc::Tool& tool : tools.all()) {
    if (scan.may_use(tool.number) || tool.number == tool_in_spindle) used.push_back(tool);
  }
  return used;
}

}  // namespace plumbline::jobs
