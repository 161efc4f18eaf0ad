// What is found out about a program before it is executed.
#pragma once

#include <vector>

#include "base/axes.hpp"
#include "nc/language/dialect.hpp"
#include "nc/language/tool_table.hpp"

namespace plumbline::compensate {

/// What a program says of itself before its first block with a feed or an axis; what it does not say is the control's.
struct Beginning {
  bool states_unit = false;       // G20, G21
  bool states_distance = false;   // G90, G91
  bool states_feed_mode = false;  // G93 to G95
  AxisSet reached;                // that its first block with axes brings to their places, wherever they stood: G0
  bool may_restore_g92 = false;   // somewhere in it: G92.3
};

struct ProgramSurvey {
  const nc::Dialect& dialect;
  AxisSet named;                  // axes that some word of it names
  std::vector<nc::Tool> tools{};  // of the table, that it may use
  Beginning beginning{};          // of a program for LinuxCNC

  /// Rotary axes that no word names.
  AxisSet unnamed() const { return AxisSet::rotary() - named; }
};

}  // namespace plumbline::compensate
