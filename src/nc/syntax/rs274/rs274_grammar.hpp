// Blocks of RS274/NGC, and of macro B, which adds statements and settings to them.
#pragma once

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// Reads the whole line: block = percent | [ "/" ] , [ line number ] , ( items | flow ).
void read_rs274_block(BlockReading& in);

}  // namespace plumbline::nc
