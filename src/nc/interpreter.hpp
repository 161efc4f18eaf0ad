// Executes blocks one after the other, as the control would.
#pragma once

#include "nc/control.hpp"
#include "nc/execution.hpp"
#include "nc/expression.hpp"
#include "nc/readings.hpp"

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
  bool ended() const { return control_.ended; }
  Control& control() { return control_; }

 private:
  void begin(const Block& block);
  void finish();
  bool deleted(const Block& block);
  void evaluate(Block& block);
  void apply_settings(const Block& block);
  void act(const Chosen& chosen);
  void act_on_mode(const Chosen& chosen);
  void change_unit(bool inches);
  void move();

  Control control_;
  Modal before_;
  Readings readings_;
  Evaluator evaluator_;
  std::vector<Value> setting_values_;
  std::vector<int> setting_numbers_;
  Execution run_;
};

}  // namespace plumbline::nc
