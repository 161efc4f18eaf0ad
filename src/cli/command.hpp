// What the commands have in common.
#pragma once

#include <functional>
#include <stdexcept>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace plumbline::cli {

/// The command line does not say what is needed: exit code 2. what() says what is expected.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kFound = 3;  // done, and what was looked for was found: limits broken, programs that differ

/// What was asked for, once the command line has been read; returns the exit code.
using Run = std::function<int()>;

// Each adds its command to `app`, and puts what it does into `run` when it is the one asked for.
void add_calibrate(CLI::App& app, Run& run);
void add_compensate(CLI::App& app, Run& run);
void add_circularity(CLI::App& app, Run& run);
void add_compare(CLI::App& app, Run& run);
void add_diagnose(CLI::App& app, Run& run);
void add_diff(CLI::App& app, Run& run);
void add_identify(CLI::App& app, Run& run);
void add_error(CLI::App& app, Run& run);
void add_explain(CLI::App& app, Run& run);
void add_plan(CLI::App& app, Run& run);
void add_restore(CLI::App& app, Run& run);
void add_check(CLI::App& app, Run& run);
void add_simulate(CLI::App& app, Run& run);
void add_trace(CLI::App& app, Run& run);

}  // namespace plumbline::cli
