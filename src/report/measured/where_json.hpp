// Where model and measurements disagree, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "diagnose/diagnose.hpp"

namespace plumbline::report {

/// A number with six digits, as JSON has it; null if it is not finite.
nlohmann::ordered_json rounded(double value);

/// The key "where" of a diagnosis, in the units of files.
nlohmann::ordered_json where_json(const diagnose::GapMap& map);

/// Predicted circularity of all runs that have readings of the bar, m.
struct CircularityOfRuns {
  diagnose::Circularity mean, largest;
  int runs = 0;  // that have them
};
CircularityOfRuns circularity_of(const std::vector<diagnose::RunGap>& runs);

/// The same in um; null if no run has readings of the bar.
nlohmann::ordered_json circularity_json(const CircularityOfRuns& circularity);

}  // namespace plumbline::report
