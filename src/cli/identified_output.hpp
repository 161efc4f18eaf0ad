// What identify and calibrate write.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "jobs/identify.hpp"

namespace plumbline::cli {

/// Where the results go, and whether a model is written against which something speaks.
struct IdentifiedOutput {
  std::string model, json, report;
  bool force = false;
};

/// The options -o MODEL2, which is required, --json FILE, --report FILE.html and --force.
void add_identified_output(CLI::App& command, IdentifiedOutput& output);

/// Checks that the outputs overwrite none of the inputs, makes the model, prints what was found, and writes all.
/// Refuses with identify-not-converged, and with identify-not-plausible unless it is forced: JSON and page written and
/// the model not. Returns the exit code.
int write_identified(const std::vector<std::string>& inputs, const IdentifiedOutput& output,
                     const std::function<jobs::IdentifiedModel()>& make);

}  // namespace plumbline::cli
