// Loops of controls with statements, and what a condition leaves out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "nc/control/interpreter.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/label_index.hpp"
#include "nc/sequence/program_files.hpp"

namespace plumbline::nc {

class StatementLoops {
 public:
  /// All must outlive it.
  StatementLoops(ProgramFiles& files, LabelIndex& labels, Interpreter& interpreter)
      : files_(files), labels_(labels), interpreter_(interpreter) {}

  /// WHILE, DO, LOOP, REPEAT without labels.
  void begin(const Block& block);
  /// Gives how many blocks a loop with nothing in it executes, as its first pass begins; else 0.
  std::uint64_t begin_for(const Block& block);
  /// Gives the pass that begins, if one does. Refuses with nc-flow-label the end of what was not begun.
  FlowEntry end(const Block& block);
  /// IF, ELSE and ENDIF. Where a condition does not hold, and at an ELSE that is reached from above, reading goes on at
  /// the line that ends what is left out. The lines before that are not parsed, as the control does not.
  void branch(const Block& block);
  /// True if this line is read since it ends what was left out last: it does nothing else.
  bool ends_left_out(const Block& block) { return std::exchange(left_out_up_to_, 0) == block.line; }
  /// Refuses with nc-flow-label, at the block that jumps, a jump into a loop or a branch that does not hold the line
  /// which it leads away from.
  void check_jump(const Block& block, std::size_t from, std::size_t to);
  /// Refuses with nc-not-interpreted, at the block that repeats or calls these lines, what holds one end of a loop or a
  /// branch alone.
  void check_part(const Block& block, std::size_t first, std::size_t last);
  /// A jump to this line of the same program: loops that it leads out of are over.
  void leave_by_jump(std::size_t line);

  /// A subprogram begins, which has loops of its own; begins once more; ends.
  void enter_call() { levels_.emplace_back(); }
  void begin_call_again() { levels_.back().clear(); }
  void leave_call() { levels_.pop_back(); }

 private:
  struct Loop {
    FlowWord word = FlowWord::none;
    LinePlace begin;      // of the line that begins it
    LinePlace content;    // of the line after
    std::size_t end = 0;  // the line that ends it
    double limit = 0;     // of FOR
    std::uint64_t pass = 1;
    bool counts_on = false;  // FOR is reached from its end
  };

  std::vector<Loop>& loops() { return levels_.back(); }
  const Nesting& nesting() { return labels_.nesting(interpreter_.leaves_out_skipped()); }
  const NestedPart& part_of(const Block& block);
  std::vector<Loop>::iterator begun_at(const Block& block);
  Loop& ended_by(const Block& block);
  FlowEntry go_back(Loop& loop, const LinePlace& to);
  void leave_out(const Block& block, const NestedPart& part, const LinePlace& up_to);

  ProgramFiles& files_;
  LabelIndex& labels_;
  Interpreter& interpreter_;
  std::vector<std::vector<Loop>> levels_ = std::vector<std::vector<Loop>>(1);  // of calls, the program itself first
  std::size_t left_out_up_to_ = 0;                                             // this line; 0: nothing was left out
};

}  // namespace plumbline::nc
