// Executes blocks one after the other, as the control would.
#pragma once

#include <vector>

#include "nc/control/block_values.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/saved_modes.hpp"
#include "nc/control/second_pass.hpp"
#include "nc/control/state/control.hpp"

namespace plumbline::nc {

class Interpreter {
 public:
  /// Both must outlive it.
  Interpreter(const Dialect& dialect, const ProgramSettings& settings);
  Interpreter(Interpreter&&) = delete;

  /// What the block does. Gives its words their values. Holds until the next call.
  const Step& execute(Block& block);
  /// A line that the control does not execute.
  const Step& pass(const Block& block);
  /// True if block delete leaves the block out; refuses where no option says.
  bool deleted(const Block& block);
  /// The value of an expression of the block; refuses one that only the machine knows.
  double value_of(const Block& block, std::uint32_t code, Span span) { return values_.value_of(block, code, span); }
  /// A subprogram of O words begins. Its own numbers are the arguments and zeros.
  void enter_o_word(LocalNumbers numbers, const std::vector<double>& arguments);
  /// A subprogram of a control with statements begins. Its variables 1 to `variables`, which begin without a value, and
  /// its names are its own.
  void enter_with_own(int variables);
  /// The same; all variables and names are its caller's.
  void enter_sharing();
  /// G65: gives the subprogram just entered its arguments.
  void set_macro_arguments();
  /// The subprogram just entered will be called once more by the same block, and it begins that call.
  void remember_call() { control_.parameters.remember_begin(); }
  void call_again() { control_.parameters.begin_again(); }
  /// Blocks behind / are not executed.
  bool leaves_out_skipped() const { return run_.settings.block_delete.value_or(false); }
  /// No option says whether they are.
  bool may_leave_out_skipped() const { return !run_.settings.block_delete && !run_.settings.as_with_empty_tables; }
  /// The settings of a block that steers.
  void assign(const Block& block) { values_.assign(block); }
  std::vector<Value> values_of_call(const Block& block) { return values_.values_of_call(block); }
  /// The variable that a setting of the block sets.
  Value variable(const Block& block, std::size_t setting) { return values_.variable(block, setting); }
  void set_variable(const Block& block, std::size_t setting, Value value) {
    values_.set_variable(block, setting, value);
  }
  /// The one that a loop counted, after its last pass.
  void set_counted(const Block& block, std::size_t setting, double last) { values_.set_counted(block, setting, last); }
  /// One of the calls of M98 P L ends, and the next begins: M73 brings modes back, none are kept.
  void end_pass(const Block& block);
  /// It ends; M73 brings modes back.
  void leave_subprogram(const Block& block);
  /// The step just made, to be added to.
  Step& step() { return run_.step; }
  const ProgramCall& program_call() const { return run_.call; }
  bool ended() const { return control_.ended; }
  bool position_read() const { return control_.position_read; }
  /// M99 of the main program begins it again: refused where a mode that it found at its start, and did not state before
  /// it moved, is another one by now.
  void check_begins_again(const Block& block) const;
  void check_last_comment(const Block& block) const;
  /// The program or subprogram that is executed has variables of its own with names.
  bool has_names() const { return control_.parameters.has_own_names(); }
  /// How often a variable of the program got another value.
  std::uint64_t changes_of_variables() const { return control_.parameters.changes(); }
  /// M30 ended a subprogram alone.
  void go_on() { control_.ended = false; }
  Control& control() { return control_; }

 private:
  void begin(const Block& block);
  void note_passed(const Block& block);
  void finish();
  bool act_on_saved_modes(const Chosen& chosen);
  bool main_begins_again() const;

  Control control_;
  Modal before_;
  SecondPass second_pass_;
  Frame frame_of_block_;                           // where the work system is that of one block alone
  std::vector<ModesOfCall> saved_{ModesOfCall{}};  // one a call level, the program itself first
  Execution run_;
  std::uint64_t changes_at_start_;
  BlockValues values_;
};

}  // namespace plumbline::nc
