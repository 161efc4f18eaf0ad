// Lines that steer a program of RS274/NGC: O words.
#pragma once

#include "nc/syntax/reading/block_reading.hpp"

namespace plumbline::nc {

/// token() is the O. Reads the line to its end: the label, the keyword and its values; refuses all else but comments.
void read_o_word(BlockReading& in);

}  // namespace plumbline::nc
