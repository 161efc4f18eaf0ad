// The options from which a case is drawn, on a command line.
#pragma once

#include <CLI/CLI.hpp>

#include "truth/drawn_case.hpp"

namespace truth {

/// Adds --seed, --machine, --effect and all that belongs to the drawing; they go into `options` as the line is parsed.
void add_case_options(CLI::App& app, CaseOptions& options);

/// What cannot be drawn throws std::runtime_error.
void check_case_options(const CaseOptions& options);

}  // namespace truth
