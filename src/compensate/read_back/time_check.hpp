// Holds the time that moves of an output take against what was meant.
#pragma once

#include <cstddef>

#include "compensate/read_back/figures.hpp"
#include "compensate/read_back/intended.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::compensate {

class TimeCheck {
 public:
  /// `tolerance`: share of a move's time that it may change by.
  TimeCheck(const nc::Dialect& dialect, double tolerance) : dialect_(dialect), tolerance_(tolerance) {}

  void begin_move() { spent_ = length_ = linear_mm_ = 0; }
  /// A move of the output is the one that was meant, or a piece of it.
  void spend(const IntendedMove& meant, const nc::Motion& motion);
  /// All of it was read, of the block in `line`. Throws Difference.
  void end_move(const IntendedMove& meant, const SourceLine& at, ReadBackFigures& figures) const;

 private:
  const nc::Dialect& dialect_;
  double tolerance_;
  double spent_ = 0;   // s, revolutions under G95
  double length_ = 0;  // way, mm and deg
  double linear_mm_ = 0;
};

}  // namespace plumbline::compensate
