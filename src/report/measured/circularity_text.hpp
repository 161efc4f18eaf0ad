// The figures of ISO 230-4, for people and as JSON.
#pragma once

#include <string>

#include "jobs/circularity.hpp"

namespace plumbline::report {

/// Two tables, um.
std::string circularity_text(const jobs::CircularityTable& table);
/// `"plumbline": "circularity 1"`, um and deg.
std::string circularity_json(const jobs::CircularityTable& table);

}  // namespace plumbline::report
