// Columns of the tables that commands write.
#pragma once

#include <iterator>
#include <string>

#include <fmt/format.h>

namespace plumbline::report {

/// Numbers counted in a unit, each after a comma.
template <class Numbers>
void append_columns(std::string& line, const Numbers& numbers, double unit, int decimals) {
  for (const double number : numbers) fmt::format_to(std::back_inserter(line), ",{:.{}f}", number / unit, decimals);
}

}  // namespace plumbline::report
