// What holds of the settings of a program, in words and as JSON.
#pragma once

#include <string>

#include "settings/resolved.hpp"

namespace plumbline::report {

/// Each option that is stated, with its text and where that stands; the files, the machines, the output that a program
/// would have. `program` may be empty: none was named.
std::string settings_text(const settings::ResolvedSettings& resolved, const std::string& program);
std::string settings_json(const settings::ResolvedSettings& resolved, const std::string& program);

}  // namespace plumbline::report
