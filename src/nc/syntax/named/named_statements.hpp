// Lines that steer a program in languages with names: IF, GOTO, FOR, CASE, REPEAT, DEF and their like.
#pragma once

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// token() is the keyword that means `word`. Reads the line to its end. Refuses a statement that is not whole, or that
/// stands after words.
void read_named_statement(BlockReading& in, FlowWord word);

}  // namespace plumbline::nc
