// Programs for a SINUMERIK, and what is told of each: the code that refuses it, or what it does.
#pragma once

#include <string>
#include <vector>

#include "nc/programs.hpp"

namespace plumbline::nc::tests {

/// `start` and `rest`, whose DEF at its begin stand before `start`, as the control has them.
std::string behind_definitions(const std::string& start, const std::string& rest);

/// Each program is `start`, with G54 known and all tables empty, and one of `rests`. What `told` makes of its motions
/// is `expected`; so is the code, where it is refused.
void check_siemens(const std::string& start, std::string (*told)(const std::vector<Motion>& motions),
                   const std::string& expected, const std::vector<std::string>& rests);

}  // namespace plumbline::nc::tests
