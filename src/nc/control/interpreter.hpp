// Executes blocks one after the other, as the control would.
#pragma once

#include "nc/control/control.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/expression.hpp"
#include "nc/control/saved_modes.hpp"
#include "nc/control/system_parameters.hpp"

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
  /// True if block delete leaves the block out; refuses when nobody said.
  bool deleted(const Block& block);
  /// The value of an expression of the block; refuses one that only the machine knows.
  double value_of(const Block& block, std::uint32_t code, Span span);
  /// A subprogram of O words begins. Its own numbers are the arguments and zeros.
  void enter_o_word(LocalNumbers numbers, const std::vector<double>& arguments);
  /// A subprogram of a control with statements begins. Its variables 1 to `variables`, which begin without a value, and
  /// its names are its own.
  void enter_with_own(int variables);
  /// The same; all variables and names are its caller's.
  void enter_sharing();
  /// G65: gives the subprogram just entered its arguments.
  void set_macro_arguments();
  /// The settings of a block that steers.
  void assign(const Block& block);
  Value value(const Block& block, std::uint32_t code);
  /// The variable that a setting of the block sets.
  Value variable(const Block& block, std::size_t setting);
  void set_variable(const Block& block, std::size_t setting, Value value);
  /// It ends; M73 brings modes back.
  void leave_subprogram(const Block& block);
  /// The step just made, to be added to.
  Step& step() { return run_.step; }
  const ProgramCall& program_call() const { return run_.call; }
  bool ended() const { return control_.ended; }
  /// M30 ended a subprogram alone.
  void go_on() { control_.ended = false; }
  Control& control() { return control_; }

 private:
  void begin(const Block& block);
  void finish();
  void evaluate(Block& block);
  void leave_out_vacant_words(Block& block);
  int setting_number(const Block& block, const Setting& setting);
  void number_settings(const Block& block);
  void evaluate_settings(const Block& block);
  Value value_before(const Block& block, std::uint32_t code, std::size_t settings);
  void apply_settings(const Block& block);
  bool passes_variables(const Block& block);
  void check_variable(const Block& block, const Setting& place);
  void set_parameter(const Block& block, const Setting& place, int number, Value value);
  void act(const Chosen& chosen);
  void act_on_position(const Chosen& chosen);
  void act_on_mode(const Chosen& chosen);
  void end_motion();
  void change_unit(bool inches);
  void set_motion_mode(const CodeRow& row);
  void move();
  void check_ends_cycle(Action action) const;
  bool moves_specially(Action action);
  void act_on_saved_modes(const Chosen& chosen);

  Control control_;
  Modal before_;
  Frame frame_of_block_;  // where the work system is that of one block alone
  SystemParameters system_parameters_;
  Evaluator evaluator_;
  std::vector<SavedModes> saved_{SavedModes{}};  // one a call level, the program itself first
  std::vector<Value> setting_values_;
  std::vector<int> setting_numbers_;
  Execution run_;
};

}  // namespace plumbline::nc
