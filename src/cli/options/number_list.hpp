// Numbers in a value of an option that is no list of its own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumbline::cli {

/// The numbers between the commas of a text. Throws UsageError, which begins with `what`, if one is none.
std::vector<double> numbers_between_commas(std::string_view text, const std::string& what);

}  // namespace plumbline::cli
