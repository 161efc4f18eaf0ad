// What a program of a high-level language begins with: PROC, then DEF, then its blocks [V p. 23].
#pragma once

#include <cstddef>
#include <cstdint>

#include "nc/language/block.hpp"
#include "nc/language/codes.hpp"
#include "nc/sequence/flow_block.hpp"
#include "nc/syntax/line_head.hpp"

namespace plumbline::nc {

class Definitions {
 public:
  /// A program or a subprogram begins.
  void begin() { *this = Definitions{}; }
  /// Its caller goes on.
  void close() { stage_ = Stage::closed; }
  bool closed() const { return stage_ == Stage::closed; }
  /// Each line of it, as it comes.
  void note(const LineHead& head, std::size_t line) {
    head_first_ = head.word == FlowWord::sub && stage_ == Stage::open;
    if (head.empty || head.bare || !head.program.empty() || closed()) return;
    const bool defines = head.word == FlowWord::sub || head.word == FlowWord::define;
    if (defines) last_ = line;
    stage_ = defines ? Stage::begun : Stage::closed;
  }
  /// Refuses PROC and DEF where the control does; a jump may lead back to them.
  void check(const Block& block) const {
    const bool head = block.flow.word == FlowWord::sub;
    const bool declares = !block.settings.empty();  // EXTERN does not
    if (head ? head_first_ : !declares || block.line <= last_) return;
    refuse_flow(block, codes::kFlowControl,
                head ? "PROC stands behind another line of its program, and the control refuses it there"
                     : "DEF stands behind a block that is none, and the control refuses it there",
                head ? "begin the subprogram with it" : "put all DEF at the begin of the program, behind its PROC");
  }

 private:
  enum class Stage : std::uint8_t { open, begun, closed };

  Stage stage_ = Stage::open;
  std::size_t last_ = 0;     // line of the last one
  bool head_first_ = false;  // PROC in this line, and nothing before it
};

}  // namespace plumbline::nc
