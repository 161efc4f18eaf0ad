// What the expressions of a block are worth, and what its settings set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "nc/control/execution.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/control/state/system_parameters.hpp"

namespace plumbline::nc {

class BlockValues {
 public:
  /// It must outlive this.
  explicit BlockValues(Execution& run);

  /// Gives the words and arguments of the block their values, and finds those of its settings. Refuses what only the
  /// machine knows.
  void evaluate(Block& block);
  /// Sets what the settings of the block set, to the values that evaluate() found.
  void apply(const Block& block);
  /// Both, of a block that steers.
  void assign(const Block& block);

  /// What the settings of a call hand over; not known where only the machine knows. Refuses a variable that is set
  /// twice, or set and used.
  std::vector<Value> values_of_call(const Block& block);
  /// What this code is worth; refuses what only the machine knows.
  double value_of(const Block& block, std::uint32_t code, Span span);
  /// The variable that a setting of the block sets.
  Value variable(const Block& block, std::size_t setting);
  void set_variable(const Block& block, std::size_t setting, Value value);
  /// The one that a loop counted, after its last pass: what is left in it was found in no source.
  void set_counted(const Block& block, std::size_t setting, double last);
  /// Of the control's state, what the program read as it found it and left otherwise; empty: nothing.
  std::string changed_since_read() const { return system_parameters_.changed_since_read(); }

 private:
  void leave_out_vacant_words(Block& block);
  int setting_number(const Block& block, const Setting& setting);
  void number_settings(const Block& block);
  void evaluate_settings(const Block& block);
  void check_set_once(const Block& block, std::size_t setting);
  Value value_before(const Block& block, std::uint32_t code, std::size_t settings, const Rounding& rounding = {});
  void set_parameter(const Block& block, const Setting& place, int number, Value value);
  void note_handed_name(const Block& block, const Setting& place, Value value);

  Execution& run_;
  SystemParameters system_parameters_;
  Evaluator evaluator_;
  std::vector<Value> setting_values_;
  std::vector<int> setting_numbers_;
};

}  // namespace plumbline::nc
