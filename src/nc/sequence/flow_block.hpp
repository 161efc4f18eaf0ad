// What a line that steers the program says: its condition, its numbers, and how it is refused.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/language/block.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {

/// Its statement, or its first word if it has none (M98).
Span steering_span(const Block& block);
/// The place of that.
Place steering_place(const Block& block);

/// Refuses with the code, at that place.
[[noreturn]] void refuse_flow(const Block& block, std::string_view code, std::string message, std::string help);

/// Whether the condition of the statement holds.
bool condition_holds(Interpreter& interpreter, const Block& block);

/// What CASE chooses by; refuses fractions, since no source says how it compares them.
double chosen_by(Interpreter& interpreter, const Block& block, std::uint32_t code);

/// The whole number that this code is worth; refuses another one, and calls it `what`.
int number_of(Interpreter& interpreter, const Block& block, std::uint32_t code, std::string_view what);

/// N10, of the number of a block; refuses one that no block has.
std::string block_name(const Block& block, int number);

inline LinePlace place_of_line(const Block& block) { return {block.offset, block.line}; }

}  // namespace plumbline::nc
