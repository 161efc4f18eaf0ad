// The limits that a program breaks, for people and as JSON.
#pragma once

#include <string>

#include "jobs/check.hpp"

namespace plumbline::report {

/// The first twenty violations, then how many blocks break which limit.
std::string check_text(const jobs::CheckSummary& summary);
/// `"plumbline": "check 1"`
std::string check_json(const jobs::CheckSummary& summary);

}  // namespace plumbline::report
