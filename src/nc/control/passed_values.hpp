// Variables in what stands in the brackets of a name, or behind its =, and is not looked into: SPOS=R1*90,
// CYCLE832(TOLERANCE,1), MSG("N "<<R2).
#pragma once

#include <vector>

#include "nc/control/execution.hpp"

namespace plumbline::nc {

/// What the names of the block pass to the control.
struct PassedValues {
  std::vector<PassedValue> values;  // in the order of the text
  bool unknown = false;             // of some variable the value is not known, or cannot be written in its place
};

/// To be called before the settings of the block are made.
PassedValues passed_values(const Execution& run, const Block& block);

}  // namespace plumbline::nc
