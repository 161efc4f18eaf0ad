// An NC program as a machine runs it: a path in time, from the motions that `plumbline trace` lists.
#pragma once

#include <string>
#include <vector>

#include "truth/motion.hpp"

namespace truth {

/// The cutting motions of a program, one after the other: axis words between the ends of a move in proportion, feeds as
/// G93 or G94 (of X, Y, Z) have them.
struct Program {
  Path path;
  double seconds = 0;
  double before = 0;              // s of path that was run before its start
  std::vector<double> ends = {};  // s, of its moves
};

/// Reads the lines of `plumbline trace`; rapids set where cutting begins. Throws std::runtime_error for what is neither
/// rapid, straight nor an arc in the XY plane.
Program read_program(const std::string& path);

/// The last whole turn of a program about a centre (metres): what a ballbar counts when it was fed in along its circle.
/// The program itself when it makes no more than one turn.
Program last_turn(const Program& program, const Vec& centre);

}  // namespace truth
