// What identify and calibrate write.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "jobs/identify.hpp"

namespace plumbline::cli {

/// The options -o MODEL2, which is required, and --json FILE.
void add_identified_output(CLI::App& command, std::string& output, std::string& json);

/// Checks that `output` and `json` (may be empty) overwrite none of the inputs, makes the model, prints what was found,
/// and writes both. Refuses with identify-not-converged, the JSON written and the model not. Returns the exit code.
int write_identified(const std::vector<std::string>& inputs, const std::string& output, const std::string& json,
                     const std::function<jobs::IdentifiedModel()>& make);

}  // namespace plumbline::cli
