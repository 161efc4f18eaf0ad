// What a misspelt command line probably meant.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <CLI/App.hpp>

namespace plumbline::cli {

/// "no command `compensat`: did you mean compensate?", likewise of the first option that its command does not have.
/// Nothing where commands and options are all known.
std::optional<std::string> what_is_unknown(const CLI::App& app, std::span<const char* const> arguments);

}  // namespace plumbline::cli
