#include "nc/sequence/statement_loops.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {

int StatementLoops::number_of_loop(const Block& block) {
  return block.flow.label == kLiteral ? 0 : number_of(interpreter_, block, block.flow.label, "the number of a loop");
}

std::vector<StatementLoops::Loop>::iterator StatementLoops::begun_at(const Block& block) {
  return std::find_if(loops().begin(), loops().end(), [&](const Loop& loop) { return loop.begin.line == block.line; });
}

void StatementLoops::begin(const Block& block) {
  const auto again = begun_at(block);
  const std::uint64_t pass = again == loops().end() ? 1 : again->pass;
  loops().erase(again, loops().end());  // left by a jump, or reached from its end
  const int number = number_of_loop(block);
  if (block.flow.word == FlowWord::begin_while && !condition_holds(interpreter_, block)) {
    return leave_out(block, FlowWord::end_while, false, number);
  }
  loops().push_back({block.flow.word, number, place_of_line(block), files_.here().line, pass});
}

void StatementLoops::begin_for(const Block& block) {
  auto loop = begun_at(block);
  const bool counted = loop != loops().end() && std::exchange(loop->counts_on, false);
  if (counted) {
    Value value = interpreter_.variable(block, 0);
    value.number += 1;
    interpreter_.set_variable(block, 0, value);
  } else {
    loops().erase(loop, loops().end());
    interpreter_.assign(block);
    loops().push_back({FlowWord::begin_for, 0, place_of_line(block), files_.here().line, 1});
  }
  const double limit = interpreter_.value_of(block, block.flow.values.front(), block.flow.span);
  const double count = interpreter_.variable(block, 0).number;
  if (count != std::round(count) || limit != std::round(limit)) {
    refuse_flow(block, codes::kNotInterpreted,
                "this counts by values that are not whole, and when they are rounded was found in no source",
                "count by whole numbers, as in FOR R1=1 TO 3, or write WHILE");
  }
  if (count <= limit) return;
  if (counted) interpreter_.set_variable(block, 0, {count, false});  // what is left in it was found in no source
  loops().pop_back();
  leave_out(block, FlowWord::end_for, false, 0);
}

// Those inside it were left by a jump.
StatementLoops::Loop& StatementLoops::innermost(const Block& block, FlowWord word, int number) {
  const bool by_number = dialect_.syntax.numbered_loops;
  for (; !loops().empty(); loops().pop_back()) {
    Loop& loop = loops().back();
    if (by_number ? loop.number == number : loop.word == word) return loop;
  }
  refuse_flow(block, codes::kFlowLabel, "this ends a loop that was not begun",
              "each end of a loop has its begin before it, in the same program");
}

FlowEntry StatementLoops::go_back(Loop& loop, const LinePlace& to) {
  ++loop.pass;
  files_.seek(to);
  return {FlowEntry::Kind::pass, {}, {}, loop.begin.line, loop.pass};
}

FlowEntry StatementLoops::end(const Block& block) {
  switch (block.flow.word) {
    case FlowWord::end_while: {
      const int number = number_of_loop(block);
      Loop& loop = innermost(block, FlowWord::begin_while, number);
      return go_back(loop, loop.begin);
    }
    case FlowWord::end_for: {
      Loop& loop = innermost(block, FlowWord::begin_for, 0);
      loop.counts_on = true;
      return go_back(loop, loop.begin);
    }
    case FlowWord::end_loop: {
      Loop& loop = innermost(block, FlowWord::begin_loop, 0);
      return go_back(loop, loop.content);
    }
    default: {
      Loop& loop = innermost(block, FlowWord::begin_repeat, 0);
      if (!condition_holds(interpreter_, block)) return go_back(loop, loop.content);
      loops().pop_back();
      return {};
    }
  }
}

void StatementLoops::leave_out_branch(const Block& block) {
  leave_out(block, FlowWord::end_if, block.flow.word == FlowWord::begin_if, 0);
}

void StatementLoops::leave_out(const Block& block, FlowWord closes, bool stops_at_else, int number) {
  const FlowWord opens = closes == FlowWord::end_if ? FlowWord::begin_if : block.flow.word;
  left_out_ = {opens, closes, stops_at_else, number, steering_place(block)};
}

void StatementLoops::pass_left_out() {
  const std::optional<LeftOut> left_out = std::exchange(left_out_, std::nullopt);
  if (!left_out) return;
  int depth = 1;
  const bool by_number = dialect_.syntax.numbered_loops;
  for (Line line; files_.next(line);) {
    const LineHead head = head_of(line.text, dialect_);
    if (!head.program.empty()) break;
    const bool steers = head.word == left_out->opens || head.word == left_out->closes ||
                        (head.word == FlowWord::otherwise && left_out->stops_at_else);
    if (steers && head.behind_slash && interpreter_.leaves_out_skipped()) {
      refuse(codes::kNotInterpreted,
             "what this line begins is left out, and a line behind / that is left out as well would end it",
             "put / before all lines of a branch or a loop, or before none", left_out->from);
    }
    if (by_number) {
      if (head.word == left_out->closes && head.loop == left_out->number) return;
      continue;
    }
    if (head.word == left_out->opens) ++depth;
    if (head.word == FlowWord::otherwise && left_out->stops_at_else && depth == 1) return;
    if (head.word == left_out->closes && --depth == 0) return;
  }
  refuse(codes::kFlowOpen, "what this line begins has no end in this program", "add it", left_out->from);
}

}  // namespace plumbline::nc
