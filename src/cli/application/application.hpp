// The command line as CLI11 knows it: what all commands have in common, and the commands.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/command.hpp"

namespace plumbline::cli {

struct Application {
  /// With every command.
  Application();
  /// With this one alone: describing all takes longer than many a run.
  explicit Application(const std::string& command);
  Application(Application&&) = delete;
  Application& operator=(Application&&) = delete;
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;
  ~Application() = default;

  CLI::App app;
  Run run;  // once `app` has read the command line
};

/// The command that stands first on the command line, or --version, which needs none and is empty. Nothing: another
/// word stands there.
std::optional<std::string> command_named(std::span<const char* const> arguments);

}  // namespace plumbline::cli
