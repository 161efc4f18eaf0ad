#include "nc/sequence/call_stack.hpp"

#include <fmt/format.h>

#include "nc/language/codes.hpp"
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

}  // namespace plumbline::nc
