// Variables that outlast the program: whether it needs them for itself alone.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nc/control/parameters/parameters.hpp"

namespace plumbline::nc {

/// A variable that a program sets, and the first line in which it does.
struct HandedVariable {
  std::string name;
  std::size_t line = 0;
  bool read = false;                 // by the program, once it was set
  bool carried = false;              // its value from before was read as well: it counts from run to run
  Value value;                       // that it was set to last
  std::optional<double> counted_to;  // by FOR, whose last pass had this value; what it left is not known
};

class HandedVariables {
 public:
  void note_read(int number);
  /// `spelt` as the program does.
  void note_set(int number, std::string_view spelt, std::size_t line, Value value);
  /// One that has a name in place of a number.
  void note_set(std::string_view name, std::size_t line, Value value);
  /// What FOR left in a variable that it set, after a last pass with this value.
  void note_counted(int number, double last) { variables_[number].counted_to = last; }
  /// One that is set for another program, or for the next run of this one; null: none is.
  const HandedVariable* first() const;
  /// One that was read before it was set, and set afterwards; null: none was.
  const HandedVariable* first_carried() const;
  /// All that were set, those with names first, each with its number (0: a name).
  std::vector<std::pair<int, const HandedVariable*>> set() const;

 private:
  static void note(HandedVariable& variable, std::string_view name, std::size_t line, Value value);
  const HandedVariable* first(bool (*is)(const HandedVariable&)) const;  // of those that are set

  std::map<int, HandedVariable> variables_;
  std::map<std::string, HandedVariable, std::less<>> named_;
};

}  // namespace plumbline::nc
