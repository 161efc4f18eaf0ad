// Loops of controls with statements, and what a condition leaves out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostic.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/program_files.hpp"

namespace plumbline::nc {

class StatementLoops {
 public:
  /// All must outlive it.
  StatementLoops(ProgramFiles& files, const Dialect& dialect, Interpreter& interpreter)
      : files_(files), dialect_(dialect), interpreter_(interpreter) {}

  /// WHILE, DO, LOOP, REPEAT without labels.
  void begin(const Block& block);
  void begin_for(const Block& block);
  /// Gives the pass that begins, if one does. Refuses with nc-flow-label the end of what was not begun.
  FlowEntry end(const Block& block);
  /// IF and ELSE: reading goes on after the ENDIF; of an IF after its ELSE, if it has one.
  void leave_out_branch(const Block& block);
  /// Passes over what was left out last. Those lines are not parsed, as the control does not.
  void pass_left_out();

  /// A subprogram begins, which has loops of its own; begins once more; ends.
  void enter_call() { levels_.emplace_back(); }
  void begin_call_again() { levels_.back().clear(); }
  void leave_call() { levels_.pop_back(); }

 private:
  struct Loop {
    FlowWord word = FlowWord::none;
    int number = 0;     // of DO
    LinePlace begin;    // of the line that begins it
    LinePlace content;  // of the line after
    std::uint64_t pass = 1;
    bool counts_on = false;  // FOR is reached from its end
  };
  struct LeftOut {  // the lines up to the end of a loop or branch
    FlowWord opens, closes;
    bool stops_at_else = false;
    int number = 0;
    Place from;
  };

  std::vector<Loop>& loops() { return levels_.back(); }
  int number_of_loop(const Block& block);
  std::vector<Loop>::iterator begun_at(const Block& block);
  Loop& innermost(const Block& block, FlowWord word, int number);
  FlowEntry go_back(Loop& loop, const LinePlace& to);
  void leave_out(const Block& block, FlowWord closes, bool stops_at_else, int number);

  ProgramFiles& files_;
  const Dialect& dialect_;
  Interpreter& interpreter_;
  std::vector<std::vector<Loop>> levels_ = std::vector<std::vector<Loop>>(1);  // of calls, the program itself first
  std::optional<LeftOut> left_out_;
};

}  // namespace plumbline::nc
