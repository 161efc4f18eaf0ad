// The text of a dataset.toml that was made by the program.
#pragma once

#include <string>
#include <string_view>

#include "measure/dataset.hpp"

namespace plumbline::measure {

/// Marker, machine and a [[run]] for each run, in the units of the file; its tables are not in it.
std::string dataset_text(const Dataset& dataset);

/// A dataset's text without what says of its tables that a plan wrote them: lines "planned = ...".
std::string without_plan(std::string_view text);

}  // namespace plumbline::measure
