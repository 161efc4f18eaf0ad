// What a misspelt command line probably meant.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <CLI/App.hpp>

namespace plumbline::cli {

/// What is wrong with a command line that could not be read, in words of its user: what is unknown, an option without
/// its value, twice, or with one that it does not take, what is too many, what is missing. Nothing: only its values
/// are.
std::optional<std::string> what_is_wrong(const CLI::App& app, std::span<const char* const> arguments);

/// "no command `compensat`: did you mean compensate?", likewise of the first option that its command does not have.
/// Nothing where commands and options are all known.
std::optional<std::string> what_is_unknown(const CLI::App& app, std::span<const char* const> arguments);

}  // namespace plumbline::cli
