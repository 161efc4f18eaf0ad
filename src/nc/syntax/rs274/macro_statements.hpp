// Lines of custom macro B that are no words: names of programs, IF, WHILE, DO, END, GOTO.
#pragma once

#include <cstdint>

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// What read_macro_statement found.
enum class MacroLine : std::uint8_t {
  words,        // no statement: the line is made of words, from token() on
  whole,        // a statement, read to the end of the line
  assignments,  // IF [..] THEN: assignments follow from token() on, and nothing else
};

/// token() is the first of the line after its number. Refuses a statement that is not whole, and what sends values out
/// of the control.
MacroLine read_macro_statement(BlockReading& in);

/// Refuses words beside an assignment, and a second one; `then`: it stands after THEN.
void check_assignment_alone(const BlockReading& in, bool then);

}  // namespace plumbline::nc
