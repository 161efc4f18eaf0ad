// LinuxCNC's own interpreter on drawn programs, many in one run.
#pragma once

#include <string>
#include <vector>

#include "drawn/drawn_program.hpp"
#include "drawn/held.hpp"
#include "support/scratch.hpp"

namespace plumbline::drawn {

/// A program and its output, if one came out.
struct Pair {
  DrawnProgram program;
  std::string output;
};

class Interpreter {
 public:
  explicit Interpreter(const Scene& scene);

  /// Runs all of them one after the other, each from the same state, and holds rs274's motions against ours. Where
  /// they differ each is run alone: the findings, by place in `pairs`.
  std::vector<std::pair<std::size_t, Finding>> check(const std::vector<Pair>& pairs, Tally& tally);
  std::optional<Finding> check(const Pair& pair);

 private:
  std::optional<Finding> compare(const std::string& text, bool block_delete);

  const Scene& scene_;
  testing::Scratch scratch_;
};

}  // namespace plumbline::drawn
