// The table of a dialect, as TOML text -> Dialect.
#pragma once

#include <string_view>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// `name` is for messages. The tables are part of plumbline: one that does not hold together is an InternalError.
Dialect read_dialect(std::string_view name, std::string_view text);

}  // namespace plumbline::nc
