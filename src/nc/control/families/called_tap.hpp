// How fast CYCLE84 and CYCLE840 tap.
#pragma once

#include "nc/control/execution.hpp"
#include "nc/control/families/called_values.hpp"

namespace plumbline::nc {

/// Of the way down, or `up`, in the unit of the feed in force: pitch x speed in mm/min, or F. Refuses values that give
/// no feed.
double tapping_feed(const Execution& run, const CalledValues& given, const Places& places, bool up);

}  // namespace plumbline::nc
