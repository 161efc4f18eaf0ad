// Options that cannot be meant together.
#pragma once

#include <optional>
#include <string>

#include "settings/options.hpp"

namespace plumbline::settings {

/// What two of the options say that cannot both be: a sentence. Nothing: they agree.
std::optional<std::string> contradiction(const Options& options);
/// True if an option is of no use beside another one, which takes its place.
bool excludes(const OptionRow& one, const OptionRow& other);

}  // namespace plumbline::settings
