// Loops and branches. What is left out ends at the next O word with the same label, whatever it says [LinuxCNC,
// measured]; this is how BREAK and CONTINUE find the end of their loop.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/sequence/flow.hpp"

namespace plumbline::nc {
namespace {

[[noreturn]] void refuse_label(const Block& block, std::string message) {
  refuse_at(block, block.flow.span, codes::kFlowLabel, std::move(message),
            "each loop and branch has a label of its own, which all its O words bear");
}

}  // namespace

// The loop is entered, or begins again where it jumped back.
void FlowControl::note_pass(Target& loop) {
  loop.pass = std::exchange(jumps_back_, false) ? loop.pass + 1 : 1;
  entry_ = {FlowEntry::Kind::pass, {}, {}, loop.place.line, loop.pass};
}

FlowControl::Target& FlowControl::begin_loop(const Block& block, const std::string& label) {
  Target& target = targets_.try_emplace(label, Target{block.flow.word, file_, place_of_line(block)}).first->second;
  if (target.file != file_ || target.place.line != block.line) {
    refuse_label(block, fmt::format("this label stands in line {} already", target.place.line));
  }
  return target;
}

const FlowControl::Target& FlowControl::need_target(const Block& block, const std::string& label, FlowWord a,
                                                    FlowWord b) const {
  const auto at = targets_.find(label);
  if (at == targets_.end()) refuse_label(block, "nothing with this label was begun");
  if (at->second.word != a && at->second.word != b) {
    refuse_label(block, fmt::format("what line {} began with this label is of another kind", at->second.place.line));
  }
  return at->second;
}

void FlowControl::steer(const Block& block, const std::string& label) {
  switch (block.flow.word) {
    case FlowWord::begin_do: {
      skip_.clear();
      note_pass(targets_.try_emplace(label, Target{FlowWord::begin_do, file_, place_of_line(block)}).first->second);
      return;
    }
    case FlowWord::repeat: {
      Target& target = begin_loop(block, label);
      skip_.clear();
      if (target.remaining < 0) {
        const double count = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
        target.remaining = static_cast<int>(std::lround(std::clamp(count, 0.0, 1e9)));
      }
      if (target.remaining-- <= 0) {
        skip_to(block, label, "the ENDREPEAT of this loop");
      } else {
        note_pass(target);
      }
      jumps_back_ = false;
      return;
    }
    case FlowWord::leave:
    case FlowWord::go_on: {
      need_target(block, label, FlowWord::begin_while, FlowWord::begin_do);
      if (block.flow.word == FlowWord::go_on && skipping()) return;
      (block.flow.word == FlowWord::leave ? breaking_ : continuing_) = true;
      skip_to(block, label, "the end of this loop");
      return;
    }
    case FlowWord::begin_while:
    case FlowWord::end_while:
    case FlowWord::end_repeat:
      return end_loop(block, label);
    default:
      return branch(block, label);
  }
}

// WHILE begins its loop or ends one that DO began; ENDWHILE and ENDREPEAT end theirs.
void FlowControl::end_loop(const Block& block, const std::string& label) {
  if (block.flow.word == FlowWord::begin_while) {
    const auto at = targets_.find(label);
    const bool ends_do = at != targets_.end() && at->second.word == FlowWord::begin_do;
    Target& loop = ends_do ? at->second : begin_loop(block, label);
    skip_.clear();
    const bool holds = condition(block);
    if (!ends_do) {
      if (holds) {
        note_pass(loop);
      } else {
        skip_to(block, label, "the ENDWHILE of this loop");
      }
      jumps_back_ = false;
    } else if (holds && !breaking_) {
      jumps_back_ = true;
      go_to(loop);
    } else {
      breaking_ = false;
    }
    return;
  }
  const FlowWord begin = block.flow.word == FlowWord::end_while ? FlowWord::begin_while : FlowWord::repeat;
  const Target& target = need_target(block, label, begin, begin);
  if (skipping()) {
    skip_.clear();
    if (!std::exchange(continuing_, false)) return;
  }
  jumps_back_ = true;
  go_to(target);
}

void FlowControl::branch(const Block& block, const std::string& label) {
  const auto leave_out = [&] { skip_to(block, label, "the ENDIF of this branch"); };
  if (block.flow.word == FlowWord::begin_if) {
    begin_loop(block, label);
    executed_branch_ = condition(block);
    if (!executed_branch_) leave_out();
    return;
  }
  need_target(block, label, FlowWord::begin_if, FlowWord::begin_if);
  if (block.flow.word == FlowWord::end_if) {
    skip_.clear();
    executed_branch_ = true;  // of the branch around it, or it would not be executed
    return;
  }
  if (executed_branch_) return leave_out();
  if (block.flow.word == FlowWord::else_if && !condition(block)) return;
  executed_branch_ = true;
  skip_.clear();
}

}  // namespace plumbline::nc
