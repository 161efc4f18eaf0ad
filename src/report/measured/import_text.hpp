// What an import took for what, in words.
#pragma once

#include <string>

#include "imported/import.hpp"

namespace plumbline::report {

/// A line for each run; `in_full`: files and columns, too.
std::string import_text(const imported::Imported& made, bool in_full);

}  // namespace plumbline::report
