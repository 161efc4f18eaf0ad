// Blocks of RS274/NGC, and of macro B, which adds statements and settings to them.
#pragma once

#include "nc/syntax/block_reading.hpp"

namespace plumbline::nc {

/// Reads the whole line: block = percent | [ "/" ] , [ line number ] , ( items | flow ).
void read_rs274_block(BlockReading& in);

/// token() is %, with which a program begins or ends. Refuses what stands behind it where the control does.
void read_percent(BlockReading& in);

}  // namespace plumbline::nc
