// The words of a canned cycle.
#pragma once

#include "nc/control/execution.hpp"

namespace plumbline::nc {

/// Takes them into control.cycle, in mm and s; those that are missing stay as the cycle before left them where this one
/// goes on from it, else a word that the cycle needs is asked for.
void take_cycle_words(Execution& run, bool goes_on);

}  // namespace plumbline::nc
