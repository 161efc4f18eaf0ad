// What an identification found, for people and as JSON.
#pragma once

#include <string>

#include "identify/identify.hpp"

namespace plumbline::report {

/// What was found, for people: values before and after, what the data cannot tell, the gap before and after.
std::string identification_text(const identify::Identification& found);
/// As docs/formats.md says.
std::string identification_json(const identify::Identification& found);

}  // namespace plumbline::report
