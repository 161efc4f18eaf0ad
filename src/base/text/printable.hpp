// What comes from files and command lines, made fit for a terminal: no byte of it steers one.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// Control characters, marks that turn the direction of writing, and bytes that are no UTF-8 as \x1b, \u202e and so on.
std::string printable(std::string_view text);

/// The same of a text of several lines: line ends and tabs stay. JSON remains the same JSON.
std::string printable_lines(std::string_view text);

/// Blanks in place of them, as many as there were bytes: for what stands above a caret.
std::string blanked(std::string_view text);

}  // namespace plumbline
