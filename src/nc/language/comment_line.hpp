// What plumbline writes into programs beside their blocks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// How many characters of a comment a line of the dialect has room for.
std::size_t comment_room(const Dialect& dialect);

/// The text as a comment of the dialect, as far as there is room; in capitals where the control drops small letters.
std::string comment_line(std::string_view text, const Dialect& dialect);

}  // namespace plumbline::nc
