// The command line described for programs: manual pages and completions are made of it (cmake/command_pages.py).
#pragma once

#include <string>

#include <CLI/App.hpp>

namespace plumbline::cli {

/// JSON: the program, its commands, and of each its positionals and options: names, what stands for the value, what it
/// is for, whether it is required or a switch, and the values that it takes where these are few.
std::string description_json(const CLI::App& app);

}  // namespace plumbline::cli
