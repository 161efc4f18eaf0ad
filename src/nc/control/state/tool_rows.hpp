// What is known of a tool: its row of the user's table, and what the program wrote into the control's (G10 L1, L10,
// L11).
#pragma once

#include <optional>

#include "nc/control/state/control.hpp"

namespace plumbline::nc {

/// What the tool adds to the control's display; nothing where no table has it.
std::optional<AxisWords> offset_of_tool(const Control& control, const ProgramSettings& settings, int number);

/// Of #5400 to #5413 and the tool in the spindle, in mm and deg; nothing where it was not given.
std::optional<double> tool_parameter(const Control& control, const ProgramSettings& settings, int number);

}  // namespace plumbline::nc
