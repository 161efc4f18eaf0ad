#include "nc/sequence/sections/repeated_sections.hpp"

#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"

namespace plumbline::nc {

RepeatedSections::GoesOn RepeatedSections::begin(const RepeatedSection& section) {
  sections_.push_back(section);
  return next_pass();
}

RepeatedSections::GoesOn RepeatedSections::next_pass() {
  RepeatedSection& section = sections_.back();
  --section.remaining;
  ++section.pass;
  return {section.begin, FlowEntry{FlowEntry::Kind::pass, {}, {}, section.begin.line, section.pass}};
}

std::optional<RepeatedSections::GoesOn> RepeatedSections::after(std::size_t line, std::size_t level) {
  if (sections_.empty() || sections_.back().level != level || line < sections_.back().end) {
    return std::nullopt;
  }
  if (sections_.back().remaining > 0) return next_pass();
  const LinePlace back = sections_.back().back;
  sections_.pop_back();
  return GoesOn{back, std::nullopt};
}

void RepeatedSections::check_jump(const Block& block, const LinePlace& to, std::size_t level) const {
  if (sections_.empty() || sections_.back().level != level) return;
  const RepeatedSection& section = sections_.back();
  if (to.line >= section.begin.line && to.line < section.end) return;
  refuse_flow(block, codes::kNotInterpreted, "this jumps out of a part of the program that is being repeated",
              "write the part as a subprogram, or as a loop");
}

void RepeatedSections::leave(std::size_t level) {
  while (!sections_.empty() && sections_.back().level == level) sections_.pop_back();
}

}  // namespace plumbline::nc
