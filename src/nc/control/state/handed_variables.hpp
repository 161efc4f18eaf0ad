// Variables that outlast the program: whether it needs them for itself alone.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace plumbline::nc {

/// A variable that a program sets, and the first line in which it does.
struct HandedVariable {
  std::string name;
  std::size_t line = 0;
  bool read = false;     // by the program, once it was set
  bool carried = false;  // its value from before was read as well: it counts from run to run
};

class HandedVariables {
 public:
  void note_read(int number);
  /// `name` as the program spells it.
  void note_set(int number, std::string_view name, std::size_t line);
  /// One that is set for another program, or for the next run of this one; null: none is.
  const HandedVariable* first() const;
  /// One that was read before it was set, and set afterwards; null: none was.
  const HandedVariable* first_carried() const;

 private:
  const HandedVariable* first(bool (*is)(const HandedVariable&)) const;  // of those that are set

  std::map<int, HandedVariable> variables_;
};

}  // namespace plumbline::nc
