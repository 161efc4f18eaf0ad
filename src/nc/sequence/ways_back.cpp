#include "nc/sequence/ways_back.hpp"

#include <optional>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"

namespace plumbline::nc {
namespace {

constexpr int kLoopNumbers = 3;  // [B-63174EN 13]

}  // namespace

void WaysBack::check_loop(const Block& block) {
  if (!dialect_.syntax.numbered_loops || block.flow.label == kLiteral) return;
  const int number = number_of(interpreter_, block, block.flow.label, "the number of a loop");
  if (number < 1 || number > kLoopNumbers) {
    refuse_flow(block, codes::kFlowControl, fmt::format("the control has no loop with the number {}", number),
                "loops are DO 1, DO 2 and DO 3; put a loop that lies deeper into a subprogram");
  }
  if (!checked_.emplace(files_.current(), block.line).second) return;
  const std::optional<std::size_t> line = labels_.crossing(block.line);
  if (!line) return;
  refuse_flow(block, codes::kFlowControl,
              fmt::format("the loop that begins here and that of line {} cross, or have one number", *line),
              "let each DO have its END before that of the loop around it, and a number of its own");
}

void WaysBack::check_way_back(const Block& block) { check_against(block, changes_at_); }

void WaysBack::check_main_again(const Block& block) { check_against(block, changes_of_main_at_); }

void WaysBack::check_against(const Block& block, ChangesAt& changes_at) {
  const std::uint64_t changes = interpreter_.changes_of_variables();
  const auto [at, is_new] = changes_at.try_emplace({files_.current(), block.line}, changes);
  const std::uint64_t before = std::exchange(at->second, changes);
  if (is_new || before != changes || interpreter_.position_read()) return;
  refuse_flow(block, codes::kTooManyBlocks,
              "this leads back without end: no variable has changed since it did so before",
              "end the loop by a condition, or write M30 where the program shall end");
}

}  // namespace plumbline::nc
