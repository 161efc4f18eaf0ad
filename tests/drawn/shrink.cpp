#include "drawn/shrink.hpp"

#include <algorithm>
#include <sstream>

namespace plumbline::drawn {
namespace {

bool drop_blocks(DrawnProgram& program, const std::function<bool(const DrawnProgram&)>& still) {
  bool dropped = false;
  for (std::size_t size = std::max<std::size_t>(1, program.blocks.size() / 2); size > 0; size /= 2) {
    for (std::size_t at = program.blocks.size(); at-- > 0;) {
      if (at + size > program.blocks.size()) continue;
      DrawnProgram less = program;
      less.blocks.erase(less.blocks.begin() + static_cast<std::ptrdiff_t>(at),
                        less.blocks.begin() + static_cast<std::ptrdiff_t>(at + size));
      if (!still(less)) continue;
      program = std::move(less);
      dropped = true;
    }
  }
  return dropped;
}

// A multi-line block becomes blocks of a line.
void split_lines(DrawnProgram& program) {
  std::vector<DrawnBlock> lines;
  for (const DrawnBlock& block : program.blocks) {
    std::istringstream in(block.text);
    std::string line;
    bool any = false;
    while (std::getline(in, line)) {
      lines.push_back({line, std::nullopt});
      any = true;
    }
    if (!any) lines.push_back({"", std::nullopt});
    lines.back().ends = block.ends;
  }
  program.blocks = std::move(lines);
}

bool drop_words(DrawnProgram& program, const std::function<bool(const DrawnProgram&)>& still) {
  bool dropped = false;
  for (DrawnBlock& block : program.blocks) {
    std::size_t at = 0;
    while (at < block.text.size()) {
      const std::size_t next = std::min(block.text.find(' ', at), block.text.size());
      const std::string whole = block.text;
      block.text.erase(at, next - at + 1);
      while (!block.text.empty() && block.text.back() == ' ') block.text.pop_back();
      if (still(program)) {
        dropped = true;
      } else {
        block.text = whole;
        at = next + 1;
      }
    }
  }
  return dropped;
}

}  // namespace

DrawnProgram shrunk(DrawnProgram program, const std::function<bool(const DrawnProgram&)>& still) {
  drop_blocks(program, still);
  split_lines(program);
  for (int round = 0; round < 4; ++round) {
    const bool blocks = drop_blocks(program, still);
    const bool words = drop_words(program, still);
    if (!blocks && !words) break;
  }
  return program;
}

}  // namespace plumbline::drawn
