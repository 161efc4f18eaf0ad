// CASE, and parts of a program that are repeated by their labels [A 1.13, 1.14].
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/sequence/statement_flow.hpp"

namespace plumbline::nc {

void StatementFlow::choose(const Block& block) {
  const double value = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
  for (const Choice& choice : block.flow.choices) {
    const bool is_default = choice.value == kLiteral;
    if (!is_default && interpreter_.value_of(block, choice.value, block.flow.span) != value) continue;
    return jump(block, canonical_label(block.at(choice.label)), choice.direction);
  }
}

// From the label to this line, to ENDLABEL: or to the second label; or the line of the label alone.
void StatementFlow::repeat(const Block& block) {
  used_ = true;
  const int count = block.flow.count == kLiteral ? 1 : number_of(block, block.flow.count, "how often this repeats");
  const std::vector<Choice>& labels = block.flow.choices;
  const auto place_of_label = [&](const Choice& choice) {
    const std::string label = canonical_label(block.at(choice.label));
    const LinePlace* const place = find_label(label, block.line, Direction::backward);
    if (place == nullptr) {
      refuse_statement(block, codes::kFlowLabel, fmt::format("there is no label {} before this line", label),
                       "a part of a program is repeated from behind it: check the label, or call a subprogram");
    }
    return *place;
  };
  Section section;
  section.begin = place_of_label(labels.front());
  section.end = block.line;
  if (block.flow.word == FlowWord::repeat_line) {
    section.end = section.begin.line + 1;
  } else if (labels.size() == 2) {
    section.end = place_of_label(labels.back()).line + 1;
  } else if (const LinePlace* const end = find_label("ENDLABEL", section.begin.line, Direction::forward)) {
    if (end->line < block.line) section.end = end->line + 1;
  }
  if (section.end <= section.begin.line || block.line < section.end - 1) {
    refuse_statement(block, codes::kFlowLabel, "the part to repeat ends before it begins", "put its labels in order");
  }
  if (count <= 0) return;
  section.back = files_[file_]->lines.place();
  section.remaining = count;
  section.level = calls_.size();
  section.from = block.line;
  sections_.push_back(section);
  go_through_section();
}

void StatementFlow::go_through_section() {
  Section& section = sections_.back();
  --section.remaining;
  ++section.pass;
  entry_ = {FlowEntry::Kind::pass, {}, {}, section.begin.line, section.pass};
  files_[file_]->lines.seek(section.begin);
}

// True: the line is behind the part that is repeated, and reading goes on elsewhere.
bool StatementFlow::leaves_section(const Line& line) {
  if (sections_.empty() || sections_.back().level != calls_.size() || line.place.line < sections_.back().end) {
    return false;
  }
  if (sections_.back().remaining > 0) {
    go_through_section();
    return true;
  }
  const LinePlace back = sections_.back().back;
  sections_.pop_back();
  files_[file_]->lines.seek(back);
  return true;
}

// What the control does with the passes that are left is in no source.
void StatementFlow::check_jump_in_section(const Block& block, const LinePlace& to) const {
  if (sections_.empty() || sections_.back().level != calls_.size()) return;
  const Section& section = sections_.back();
  if (to.line >= section.begin.line && to.line < section.end) return;
  refuse_statement(block, codes::kNotInterpreted, "this jumps out of a part of the program that is being repeated",
                   "write the part as a subprogram, or as a loop");
}

}  // namespace plumbline::nc
