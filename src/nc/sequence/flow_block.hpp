// What a line that steers the program says: its condition, its numbers, the program that it calls, and how it is
// refused.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "nc/control/interpreter.hpp"
#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/label_index.hpp"
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

/// CALL BLOCK FIRST TO LAST; REPEAT finds its labels before it.
inline bool calls_part(const Block& block) {
  return block.flow.word == FlowWord::repeat_section && !block.flow.choices.empty() &&
         block.flow.choices.front().direction == Direction::both;
}

inline LinePlace place_of_line(const Block& block) { return {block.offset, block.line}; }

/// Where the program begins that the block calls, by its name as program_name gives it. Refuses with nc-flow-open where
/// there is none, or one but for the zeros before its number, or several in one file; under user task 2 with
/// nc-subprogram-ambiguous where another file holds it as well, or where a file that is opened for this call holds one
/// that was called before.
FilePlace program_called(const Block& block, const std::string& name, LabelIndex& labels, const Dialect& dialect);

/// P00020003 calls program 3 twice; or, on a control whose programs have eight digits, program 20003 once: its name,
/// where the file has that one and no 3. Refuses where it has both.
std::optional<std::string> program_of_eight_digits(const Block& block, const ProgramCall& program, LabelIndex& labels);

}  // namespace plumbline::nc
