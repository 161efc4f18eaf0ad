#include "nc/sequence/sections/repeated_sections.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"

namespace plumbline::nc {

namespace {

void refuse_call_of_itself(const Block& block, const RepeatedSection& section,
                           const std::vector<RepeatedSection>& running) {
  const auto runs = std::find_if(running.begin(), running.end(), [&](const RepeatedSection& one) {
    const bool same = one.begin.line == section.begin.line && one.end == section.end && one.level == section.level;
    return one.calling_line != 0 && same;
  });
  if (runs == running.end()) return;
  refuse_flow(block, codes::kNotInterpreted,
              fmt::format("the part that this calls is being executed, called in line {}: it would call itself",
                          runs->calling_line),
              "let no part call one that leads back to it, or write a loop");
}

}  // namespace

RepeatedSections::GoesOn RepeatedSections::begin(const Block& block, const RepeatedSection& section) {
  const bool is_called = section.calling_line != 0;
  if (is_called) refuse_call_of_itself(block, section, sections_);
  sections_.push_back(section);
  GoesOn there = next_pass();
  if (is_called) {
    there.entry = FlowEntry{FlowEntry::Kind::call, block.at(block.flow.choices.front().label), {}, block.line, 1};
  }
  return there;
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
