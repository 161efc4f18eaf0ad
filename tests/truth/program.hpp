// An NC program as a machine runs it: a path in time, from the motions that `plumbline trace` lists.
#pragma once

#include <string>

#include "truth/motion.hpp"

namespace truth {

/// The cutting motions of a program, one after the other: axis words between the ends of a move in proportion, feeds as
/// G93 or G94 (of X, Y, Z) have them.
struct Program {
  Path path;
  double seconds = 0;
};

/// Reads the lines of `plumbline trace`; rapids set where cutting begins. Throws std::runtime_error for what is neither
/// rapid, straight nor an arc in the XY plane.
Program read_program(const std::string& path);

}  // namespace truth
