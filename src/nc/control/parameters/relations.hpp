// EQ, NE, GT, GE, LT and LE of two numbers, as a control has them.
#pragma once

#include "nc/language/block.hpp"

namespace plumbline::nc {

/// When two numbers are the same to a control.
struct Equality {
  double within = 0;           // of EQ and NE, if they are less apart
  double relative_within = 0;  // of all six, if they are no further apart than this, of the larger of them
};

/// What a relation of the block says. Refuses with nc-not-interpreted where a relative equality decides and what it is
/// relative to, or whether > and < know it, depends on the machine.
bool compares(const Block& block, const Instruction& relation, double a, double b, const Equality& equality);

}  // namespace plumbline::nc
