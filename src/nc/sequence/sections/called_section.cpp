#include "nc/sequence/sections/called_section.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {
namespace {

constexpr std::string_view kAsSubprogram =
    "write the part as a subprogram, as posts do that write subprograms into files (useFilesForSubprograms)";

// M2, M30, M17 or an M whose number is a value, anywhere in the line; RET: whether it ends the part or the program.
bool holds_end(std::string_view line, const LineHead& head) {
  if (head.word == FlowWord::give_back) return true;
  const std::string code = upper(line.substr(0, line.find(';')));
  for (std::size_t at = code.find('M'); at != std::string::npos; at = code.find('M', at + 1)) {
    const bool in_text = std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '"') % 2 != 0;
    if (in_text || (at > 0 && is_of_name(code[at - 1]) && !is_digit(code[at - 1]))) continue;
    const std::size_t begin = std::min(code.find_first_not_of(" \t0", at + 1), code.size());
    const std::size_t end = std::min(code.find_first_not_of("0123456789", begin), code.size());
    const std::string_view number = std::string_view(code).substr(begin, end - begin);
    if (number == "2" || number == "30" || number == "17" || (begin < code.size() && code[begin] == '=')) return true;
  }
  return false;
}

[[noreturn]] void refuse_label(const Block& block, std::string_view label, std::string_view message) {
  refuse_flow(block, codes::kFlowLabel, fmt::format("{} {}", label, message), "check the names of its labels");
}

LinePlace first_of(const Block& block, LabelIndex& labels, const std::string& label) {
  const LinePlace* const place = labels.find_label(label, block.line, Direction::both);
  if (place == nullptr) refuse_label(block, label, "is no label of this program");
  const LinePlace* const other = labels.find_label(label, place->line, Direction::both);
  if (other == nullptr || other->line == place->line) return *place;
  refuse_flow(
      block, codes::kNotInterpreted,
      fmt::format("{} stands in line {} as well, and where the part begins was found in no source", label, other->line),
      "give each part a label of its own");
}

void check_line(const Block& block, const Line& line, bool last, const Dialect& dialect) {
  const LineHead head = head_of(line.text, dialect);
  if (head.behind_slash) {
    refuse_flow(block, codes::kNotInterpreted,
                fmt::format("the part holds a line with / ({}), and whether its labels are found there was found in no "
                            "source",
                            line.place.line),
                std::string(kAsSubprogram));
  }
  if (holds_end(line.text, head)) {
    refuse_flow(block, codes::kNotInterpreted,
                fmt::format("the part holds the end of a program (line {}), and what that ends there was found in no "
                            "source",
                            line.place.line),
                std::string(kAsSubprogram));
  }
  if (!last || head.bare) return;
  refuse_flow(
      block, codes::kNotInterpreted,
      fmt::format("words stand beside the label that ends the part (line {}), and whether they belong to it was "
                  "found in no source",
                  line.place.line),
      "put that label into a line of its own");
}

}  // namespace

RepeatedSection section_called(const Block& block, const ProgramFiles& files, LabelIndex& labels,
                               const Dialect& dialect, bool has_variables) {
  if (has_variables) {
    refuse_flow(block, codes::kNotInterpreted,
                "what variables of the program (DEF) are worth in a part that CALL BLOCK calls was found in no source",
                "keep them in R parameters, or write the part as a subprogram");
  }
  const std::string first = canonical_label(block.at(block.flow.choices.front().label));
  const std::string last = canonical_label(block.at(block.flow.choices.back().label));
  RepeatedSection section;
  section.begin = first_of(block, labels, first);
  const LinePlace* const end = labels.find_label(last, section.begin.line, Direction::forward);
  if (end == nullptr) refuse_label(block, last, fmt::format("is no label behind {}", first));
  section.end = end->line + 1;
  section.back = files.here().line;
  if (block.line >= section.begin.line && block.line < section.end) {
    refuse_flow(block, codes::kNotInterpreted, "the part that this calls holds the call itself",
                "write the part behind M30, or as a subprogram");
  }
  LineSource lines(files.file(files.current()));
  lines.seek(section.begin);
  for (Line line; lines.next(line) && line.place.line < section.end;) {
    check_line(block, line, line.place.line + 1 == section.end, dialect);
  }
  return section;
}

}  // namespace plumbline::nc
