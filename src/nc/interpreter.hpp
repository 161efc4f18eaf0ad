// Executes blocks one after the other, as the control would.
#pragma once

#include "nc/control.hpp"
#include "nc/execution.hpp"
#include "nc/expression.hpp"
#include "nc/readings.hpp"
#include "nc/saved_modes.hpp"

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
  /// A subprogram begins. With parameters #1..#30 of its own, these are the arguments and zeros.
  void enter_subprogram(bool own_parameters, const std::vector<double>& arguments);
  /// It ends; M73 brings modes back.
  void leave_subprogram(const Block& block);
  /// The step just made, to be added to.
  Step& step() { return run_.step; }
  const ProgramCall& program_call() const { return run_.call; }
  bool ended() const { return control_.ended; }
  Control& control() { return control_; }

 private:
  void begin(const Block& block);
  void finish();
  void evaluate(Block& block);
  void apply_settings(const Block& block);
  void act(const Chosen& chosen);
  void act_on_mode(const Chosen& chosen);
  void change_unit(bool inches);
  void move();
  bool moves_specially(Action action);
  void act_on_saved_modes(const Chosen& chosen);

  Control control_;
  Modal before_;
  Readings readings_;
  Evaluator evaluator_;
  std::vector<SavedModes> saved_{SavedModes{}};  // one a call level, the program itself first
  std::vector<Value> setting_values_;
  std::vector<int> setting_numbers_;
  Execution run_;
};

}  // namespace plumbline::nc
