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

// Every command, in the order in which help lists them. Each has a file NAME_command.cpp with add_NAME, which adds the
// command to `app` and puts what it does into `run` when it is the one asked for.
#define PLUMBLINE_COMMANDS(COMMAND) \
  COMMAND(compensate)               \
  COMMAND(batch)                    \
  COMMAND(restore)                  \
  COMMAND(error)                    \
  COMMAND(explain)                  \
  COMMAND(trace)                    \
  COMMAND(check)                    \
  COMMAND(simulate)                 \
  COMMAND(import)                   \
  COMMAND(inspect)                  \
  COMMAND(diagnose)                 \
  COMMAND(diff)                     \
  COMMAND(compare)                  \
  COMMAND(circularity)              \
  COMMAND(identify)                 \
  COMMAND(calibrate)                \
  COMMAND(plan)                     \
  COMMAND(control)                  \
  COMMAND(new_model)                \
  COMMAND(map)                      \
  COMMAND(settings)

#define PLUMBLINE_DECLARE(NAME) void add_##NAME(CLI::App& app, Run& run);
PLUMBLINE_COMMANDS(PLUMBLINE_DECLARE)
#undef PLUMBLINE_DECLARE

}  // namespace plumbline::cli
