#include "nc/sequence/statement_loops.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"

namespace plumbline::nc {
namespace {

constexpr double kMostCounted = 1e15;

}  // namespace

// Refuses where the text has it otherwise than the control takes it.
const NestedPart& StatementLoops::part_of(const Block& block) {
  const NestedPart* const part = nesting().part_at(block.line);
  if (part == nullptr) {
    refuse_flow(block, codes::kFlowControl, "this begins or ends a loop or a branch behind something else",
                "write it at the begin of its line, the number of a loop as a number, and comments behind it");
  }
  if (part->fault.empty()) return *part;
  if (part->is_open)
    refuse_flow(block, codes::kFlowOpen, part->fault,
                "add it, at the begin of a line, before that of what stands around it");
  refuse_flow(block, codes::kFlowLabel, part->fault,
              "each end has its begin before it, in the same program, and each IF one ELSE at most");
}

std::vector<StatementLoops::Loop>::iterator StatementLoops::begun_at(const Block& block) {
  return std::find_if(loops().begin(), loops().end(), [&](const Loop& loop) { return loop.begin.line == block.line; });
}

void StatementLoops::begin(const Block& block) {
  const auto again = begun_at(block);
  const std::uint64_t pass = again == loops().end() ? 1 : again->pass;
  loops().erase(again, loops().end());  // left by a jump, or reached from its end
  const NestedPart& part = part_of(block);
  if (block.flow.word == FlowWord::begin_while && !condition_holds(interpreter_, block)) {
    return leave_out(block, part, part.end);
  }
  loops().push_back({block.flow.word, place_of_line(block), files_.here().line, part.end.line, 0, pass});
}

std::uint64_t StatementLoops::begin_for(const Block& block) {
  const NestedPart& part = part_of(block);
  auto loop = begun_at(block);
  const bool counted = loop != loops().end() && std::exchange(loop->counts_on, false);
  if (counted) {
    Value value = interpreter_.variable(block, 0);
    if (!value.known) {
      refuse_flow(block, codes::kValueUnknown,
                  "this loop counts on in what another FOR of the same variable left, which was found in no source",
                  "let the inner loop count another variable");
    }
    value.number += 1;
    interpreter_.set_variable(block, 0, value);
  } else {
    loops().erase(loop, loops().end());
    interpreter_.assign(block);
    loops().push_back({FlowWord::begin_for, place_of_line(block), files_.here().line, part.end.line});
  }
  const double limit = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
  if (!counted) loops().back().limit = limit;
  if (limit != loops().back().limit) {
    refuse_flow(block, codes::kNotInterpreted,
                "the value behind TO changes while this loop counts, and whether the control takes the new one was "
                "found in no source",
                "keep it in a variable that the loop does not change, or write WHILE");
  }
  const double count = interpreter_.variable(block, 0).number;
  if (count != std::round(count) || limit != std::round(limit)) {
    refuse_flow(block, codes::kNotInterpreted,
                "this counts by values that are not whole, and when they are rounded was found in no source",
                "count by whole numbers, as in FOR R1=1 TO 3, or write WHILE");
  }
  if (count <= limit) {
    const bool counts_alone = !counted && part.end.line == part.begin.line + 1;
    return counts_alone ? static_cast<std::uint64_t>(std::min(limit - count + 1, kMostCounted)) * 2 : 0;
  }
  if (counted) interpreter_.set_counted(block, 0, count - 1);
  loops().pop_back();
  leave_out(block, part, part.end);
  return 0;
}

StatementLoops::Loop& StatementLoops::ended_by(const Block& block) {
  const NestedPart& part = part_of(block);
  if (!loops().empty() && loops().back().begin.line == part.begin.line) return loops().back();
  refuse_flow(block, codes::kFlowLabel, "this ends a loop that was not begun",
              "a jump may lead out of a loop, and not into one: let it lead to the line that begins the loop");
}

void StatementLoops::check_jump(const Block& block, std::size_t from, std::size_t to) {
  const NestedPart* const part = nesting().entered(from, to);
  if (part == nullptr) return;
  refuse_flow(block, codes::kFlowLabel,
              fmt::format("this jumps into {} that begins in line {}, without its begin",
                          part->word == FlowWord::begin_if ? "a branch of the IF" : "the loop", part->begin.line),
              "a jump may lead out of a loop or a branch, and not into one: let it lead to the line that begins it");
}

void StatementLoops::check_part(const Block& block, std::size_t first, std::size_t last) {
  const NestedPart* const part = nesting().cut_by(first, last);
  if (part == nullptr) return;
  refuse_flow(block, codes::kNotInterpreted,
              fmt::format("the part of the program that this executes (lines {} to {}) begins or ends inside {} that "
                          "begins in line {}, and what the control does then was found in no source",
                          first, last, part->word == FlowWord::begin_if ? "the branch of the IF" : "the loop",
                          part->begin.line),
              "let the part hold the whole of it, or lie inside it");
}

void StatementLoops::leave_by_jump(std::size_t line) {
  const auto holds = [line](const Loop& loop) { return line >= loop.begin.line && line <= loop.end; };
  while (!loops().empty() && !holds(loops().back())) loops().pop_back();
}

FlowEntry StatementLoops::go_back(Loop& loop, const LinePlace& to) {
  ++loop.pass;
  files_.seek(to);
  return {FlowEntry::Kind::pass, {}, {}, loop.begin.line, loop.pass};
}

FlowEntry StatementLoops::end(const Block& block) {
  Loop& loop = ended_by(block);
  switch (block.flow.word) {
    case FlowWord::end_while:
      return go_back(loop, loop.begin);
    case FlowWord::end_for:
      loop.counts_on = true;
      return go_back(loop, loop.begin);
    case FlowWord::end_loop:
      return go_back(loop, loop.content);
    default:
      if (!condition_holds(interpreter_, block)) return go_back(loop, loop.content);
      loops().pop_back();
      return {};
  }
}

void StatementLoops::branch(const Block& block) {
  const NestedPart& part = part_of(block);
  if (block.flow.word == FlowWord::end_if) return;
  if (block.flow.word == FlowWord::otherwise) return leave_out(block, part, part.end);
  if (!condition_holds(interpreter_, block)) {
    leave_out(block, part, part.otherwise.line != 0 ? part.otherwise : part.end);
  }
}

void StatementLoops::leave_out(const Block& block, const NestedPart& part, const LinePlace& up_to) {
  const bool doubtful = nesting().has_slash_between(place_of_line(block), up_to, part.word);
  if (doubtful && interpreter_.may_leave_out_skipped()) {
    refuse_flow(block, codes::kBlockDelete,
                "what this line begins is left out, and where it ends depends on a switch of the control: a line of a "
                "branch or a loop in it stands behind /",
                "say how it stands: --block-delete on leaves such lines out, off executes them");
  }
  if (doubtful && interpreter_.leaves_out_skipped()) {
    refuse_flow(block, codes::kNotInterpreted,
                "what this line begins is left out, and a line behind / that is left out as well would end it",
                "put / before all lines of a branch or a loop, or before none");
  }
  left_out_up_to_ = up_to.line;
  files_.seek(up_to);
}

}  // namespace plumbline::nc
