// Where model and measurements disagree, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "diagnose/diagnose.hpp"

namespace plumbline::jobs {

/// A number with six digits, as JSON has it; null if it is not finite.
nlohmann::ordered_json rounded(double value);

/// The key "where" of a diagnosis, in the units of files.
nlohmann::ordered_json where_json(const diagnose::Where& where);

/// Predicted circularity of all runs that have readings of the bar: means and largest, um; null if none has.
nlohmann::ordered_json circularity_json(const std::vector<diagnose::RunGap>& runs);

}  // namespace plumbline::jobs
