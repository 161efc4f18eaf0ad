#include "nc/sequence/o_word_loops.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"

namespace plumbline::nc {
namespace {

[[noreturn]] void refuse_label(const Block& block, std::string message) {
  refuse_flow(block, codes::kFlowLabel, std::move(message),
              "each loop and branch has a label of its own, which all its O words bear");
}

LeftOut up_to_label(const Block& block, const std::string& label, std::string_view what) {
  return {LeftOut::Until::any_word, label, std::string(what), steering_place(block)};
}

}  // namespace

bool LeftOut::ends_at(FlowWord word, const std::string& label_of_word) const {
  if (label_of_word != label) return false;
  switch (until) {
    case Until::end_sub:
      return word == FlowWord::end_sub;
    case Until::subprogram:
      return word == FlowWord::sub || word == FlowWord::program;
    default:
      return true;
  }
}

OWordLoops::Begin& OWordLoops::begin(const Block& block, const std::string& label) {
  const FilePlace here{files_.current(), place_of_line(block)};
  Begin& begin = begins_.try_emplace(label, Begin{block.flow.word, here, {}}).first->second;
  if (begin.place.file != here.file || begin.place.line.line != block.line) {
    refuse_label(block, fmt::format("this label stands in line {} already", begin.place.line.line));
  }
  return begin;
}

OWordLoops::Begin& OWordLoops::need(const Block& block, const std::string& label, FlowWord a, FlowWord b) {
  const auto at = begins_.find(label);
  if (at == begins_.end()) refuse_label(block, "nothing with this label was begun");
  Begin& begin = at->second;
  if (begin.word != a && begin.word != b) {
    refuse_label(block, fmt::format("what line {} began with this label is of another kind", begin.place.line.line));
  }
  return begin;
}

namespace {

// The loop is entered, or begins again where it jumped back.
template <class Begin>
FlowEntry pass_of(Begin& loop) {
  loop.pass = std::exchange(loop.next_pass, 1);
  return {FlowEntry::Kind::pass, {}, {}, loop.place.line.line, loop.pass};
}

}  // namespace

FlowEntry OWordLoops::steer(const Block& block, const std::string& label, std::optional<LeftOut>& left_out) {
  switch (block.flow.word) {
    case FlowWord::begin_do: {
      left_out.reset();
      const FilePlace here{files_.current(), place_of_line(block)};
      return pass_of(begins_.try_emplace(label, Begin{FlowWord::begin_do, here, {}}).first->second);
    }
    case FlowWord::repeat:
      return repeat(block, label, left_out);
    case FlowWord::begin_while:
      return begin_while(block, label, left_out);
    case FlowWord::leave:
    case FlowWord::go_on:
      leave(block, label, left_out);
      return {};
    case FlowWord::end_while:
    case FlowWord::end_repeat:
      end_loop(block, label, left_out);
      return {};
    default:
      branch(block, label, left_out);
      return {};
  }
}

FlowEntry OWordLoops::repeat(const Block& block, const std::string& label, std::optional<LeftOut>& left_out) {
  Begin& loop = begin(block, label);
  left_out.reset();
  if (!loop.remaining) {
    const double count = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
    loop.remaining = static_cast<int>(std::nearbyint(std::clamp(count, 0.0, 1e9)));  // 2.5 is 2 [LinuxCNC, measured]
  }
  if (*loop.remaining > 0) {
    --*loop.remaining;
    return pass_of(loop);
  }
  loop.remaining.reset();
  loop.next_pass = 1;
  left_out = up_to_label(block, label, "the ENDREPEAT of this loop");
  return {};
}

// WHILE begins its loop, or ends one that DO began.
FlowEntry OWordLoops::begin_while(const Block& block, const std::string& label, std::optional<LeftOut>& left_out) {
  const auto at = begins_.find(label);
  const bool ends_do = at != begins_.end() && at->second.word == FlowWord::begin_do;
  Begin& loop = ends_do ? at->second : begin(block, label);
  left_out.reset();
  if (ends_do) {
    end_do(block, loop);
    return {};
  }
  if (condition_holds(interpreter_, block)) return pass_of(loop);
  loop.next_pass = 1;
  left_out = up_to_label(block, label, "the ENDWHILE of this loop");
  return {};
}

void OWordLoops::end_do(const Block& block, Begin& loop) {
  const bool breaks = leaving_ == Leaving::by_break || leaving_ == Leaving::by_both;
  if (condition_holds(interpreter_, block) && !breaks) return go_back(loop);
  if (breaks) leaving_ = leaving_ == Leaving::by_both ? Leaving::by_continue : Leaving::nothing;
}

// ENDWHILE and ENDREPEAT.
void OWordLoops::end_loop(const Block& block, const std::string& label, std::optional<LeftOut>& left_out) {
  const FlowWord word = block.flow.word == FlowWord::end_while ? FlowWord::begin_while : FlowWord::repeat;
  Begin& loop = need(block, label, word, word);
  if (left_out) {
    left_out.reset();
    const bool continues = leaving_ == Leaving::by_continue || leaving_ == Leaving::by_both;
    if (!continues) return;
    leaving_ = leaving_ == Leaving::by_both ? Leaving::by_break : Leaving::nothing;
  }
  go_back(loop);
}

// BREAK and CONTINUE.
void OWordLoops::leave(const Block& block, const std::string& label, std::optional<LeftOut>& left_out) {
  need(block, label, FlowWord::begin_while, FlowWord::begin_do);
  const bool breaks = block.flow.word == FlowWord::leave;
  if (!breaks && left_out) return;
  const Leaving this_way = breaks ? Leaving::by_break : Leaving::by_continue;
  leaving_ = leaving_ == Leaving::nothing || leaving_ == this_way ? this_way : Leaving::by_both;
  left_out = up_to_label(block, label, "the end of this loop");
}

// The control stops at what it cannot evaluate behind an ELSEIF, though another branch was executed [LinuxCNC,
// measured].
void OWordLoops::evaluate_passed_over(const Block& block) {
  try {
    condition_holds(interpreter_, block);
  } catch (const Refusal& refusal) {
    if (refusal.diagnostic().code != codes::kValueUnknown) throw;
  }
}

void OWordLoops::branch(const Block& block, const std::string& label, std::optional<LeftOut>& left_out) {
  const auto leave_out = [&] { left_out = up_to_label(block, label, "the ENDIF of this branch"); };
  if (block.flow.word == FlowWord::begin_if) {
    begin(block, label);
    branch_is_executed_ = condition_holds(interpreter_, block);
    if (!branch_is_executed_) leave_out();
    return;
  }
  need(block, label, FlowWord::begin_if, FlowWord::begin_if);
  if (block.flow.word == FlowWord::end_if) {
    left_out.reset();
    branch_is_executed_ = true;  // of the branch around it, or it would not be executed
    return;
  }
  if (branch_is_executed_) {
    if (block.flow.word == FlowWord::else_if) evaluate_passed_over(block);
    return leave_out();
  }
  if (block.flow.word == FlowWord::else_if && !condition_holds(interpreter_, block)) return;
  branch_is_executed_ = true;
  left_out.reset();
}

void OWordLoops::go_back(Begin& loop) {
  loop.next_pass = loop.pass + 1;
  files_.go_to(loop.place);
}

}  // namespace plumbline::nc
