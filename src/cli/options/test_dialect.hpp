// For which control programs of circular tests are written.
#pragma once

#include <string>

#include "cli/command.hpp"

namespace plumbline::cli {

/// Adds the option --dialect NAME, which keeps `dialect` where it is not given.
void add_test_dialect(CLI::App& command, std::string& dialect);

}  // namespace plumbline::cli
