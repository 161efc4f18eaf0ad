// Steps of our own in place of a program's: blocks that are written here and parsed as a program's are.
#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "nc/control/step.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {

/// A step that owns what it refers to.
struct MadeStep {
  std::string text;
  Block block;
  Modal before, after;
  Motion motion;
  Hole hole;
  Step step;
};

/// Made steps, kept and used again from block to block.
class MadeSteps {
 public:
  /// The dialect must outlive it.
  explicit MadeSteps(const Dialect& dialect) : parser_(dialect) {}

  /// Whether it is one of those given since clear().
  bool holds(const Step& step) const;

  /// Those given so far are free again.
  void clear() { used_ = 0; }

  /// A step without text, in the state after `like`. Holds until clear().
  MadeStep& next(const Step& like);

  /// Reads its text as if it stood where the block of `like` stands.
  void parse(MadeStep& made, const Step& like);

 private:
  Parser parser_;
  std::deque<MadeStep> made_;
  std::size_t used_ = 0;
};

}  // namespace plumbline::nc
