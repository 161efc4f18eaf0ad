// The smallest part of a program that still does what the whole does.
#pragma once

#include <functional>

#include "drawn/drawn_program.hpp"

namespace plumbline::drawn {

/// Drops blocks, then words, as long as `still` holds.
DrawnProgram shrunk(DrawnProgram program, const std::function<bool(const DrawnProgram&)>& still);

}  // namespace plumbline::drawn
