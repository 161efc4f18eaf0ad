#include "nc/sequence/call_stack.hpp"

#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/sequence/flow_block.hpp"

namespace plumbline::nc {

void CallStack::check_room(const Block& block) const {
  if (calls_.size() < most_) return;
  refuse_flow(block, codes::kCallDepth, fmt::format("subprograms call each other more than {} deep", most_),
              "the control takes no more; does a subprogram call itself without an end?");
}

bool CallStack::begins_again() {
  Call& call = calls_.back();
  if (call.remaining <= 0) return false;
  --call.remaining;
  ++call.pass;
  return true;
}

FlowEntry CallStack::entry(const ProgramFiles& files) const {
  const Call& call = calls_.back();
  FlowEntry entry{FlowEntry::Kind::call, call.name, {}, call.line, call.pass};
  if (!files.in_program()) entry.file = files.name();
  return entry;
}

std::string line_of_call(const Call& call, const ProgramFiles& files) {
  const bool here = call.back.file == files.current();
  return fmt::format("line {}{}", call.line, here ? "" : " of " + files.file(call.back.file).name());
}

void take_values(const Block& block, Call& call, const ProgramFiles& files) {
  call.takes_values = true;
  if (call.arguments.size() <= block.settings.size()) return;
  refuse_flow(block, codes::kFlowControl,
              fmt::format("{} is called in {} with {} values, and takes {}", call.name, line_of_call(call, files),
                          call.arguments.size(), block.settings.size()),
              "leave values out of the call, or add parameters here");
}

void refuse_without_head(std::string_view text, std::size_t line, const Call& call, const ProgramFiles& files) {
  if (call.arguments.empty() || call.takes_values) return;
  Place place;
  place.file = files.name();
  place.line = line;
  place.column = 1;
  place.text = text;
  place.length = text.size();
  refuse(codes::kFlowControl,
         fmt::format("{} is called in {} with values, and has no PROC that takes them", call.name,
                     line_of_call(call, files)),
         "call it without values, or begin it with PROC and its parameters", std::move(place));
}

}  // namespace plumbline::nc
