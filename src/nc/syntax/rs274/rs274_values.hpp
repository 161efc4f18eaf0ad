// Values of RS274/NGC and macro B: the productions of grammar/block.ebnf from "real value" on.
#pragma once

#include <cstdint>

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// The code of the value that stands next: a number, [expression], #parameter or function. Each of these refuses what
/// is none.
std::uint32_t read_value(BlockReading& in);

/// The same, with operators after it that need no brackets.
std::uint32_t read_open_value(BlockReading& in);

/// The code of the condition whose [ is token().
std::uint32_t read_condition(BlockReading& in);

/// The name between < and > of token(), without them; its place in Block::names.
std::uint32_t read_name(BlockReading& in);

}  // namespace plumbline::nc
