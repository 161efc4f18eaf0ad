// The table of a dialect, packed (packed_table.hpp) -> Dialect.
#pragma once

#include <string_view>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// `name` is for messages. The tables are part of plumbline: one that does not hold together is an InternalError.
Dialect read_dialect(std::string_view name, std::string_view packed);
/// The same of its marks alone, which is far less.
DialectMarks read_marks(std::string_view name, std::string_view packed);

}  // namespace plumbline::nc
