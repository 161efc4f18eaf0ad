// What a drilling cycle that is called by name leaves behind.
#pragma once

#include "nc/control/execution.hpp"
#include "nc/control/families/called_values.hpp"

namespace plumbline::nc {

/// The spindle, after the cycle with this code.
void leave_spindle(Control& control, const CalledValues& given, int code);
/// F and S, where the cycle had some of its own. `last_share`: of F, that a deep hole ended with.
void leave_own_feeds(Control& control, const CalledValues& given, const CycleCall& call, double last_share);

}  // namespace plumbline::nc
