// What the values of options must be, whatever the option is for.
#pragma once

#include <CLI/CLI.hpp>

namespace plumbline::cli {

/// Throws UsageError where a value is empty (what a script meant to put there was not set) or begins with "="
/// (`-o=FILE` names a file `=FILE`).
void refuse_odd_values(const CLI::App& app);

/// What --json, --report and --depfile name may stand there already if it is of that kind: `--json *.ngc` replaces no
/// program. Refuses with file-exists.
void refuse_strange_results(const CLI::App& app);

}  // namespace plumbline::cli
