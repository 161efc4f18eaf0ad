// What is found out about a program before it is executed.
#pragma once

#include <vector>

#include "base/axes.hpp"
#include "nc/language/dialect.hpp"
#include "nc/language/tool_table.hpp"

namespace plumbline::compensate {

struct ProgramSurvey {
  const nc::Dialect& dialect;
  AxisSet named;                  // axes that some word of it names
  std::vector<nc::Tool> tools{};  // of the table, that it may use

  /// Rotary axes that no word names.
  AxisSet unnamed() const { return AxisSet::rotary() - named; }
};

}  // namespace plumbline::compensate
