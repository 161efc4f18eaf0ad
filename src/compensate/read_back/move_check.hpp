// Holds the moves of an output against what was meant: their kinds, where they end, and the words that say so.
#pragma once

#include <cstddef>

#include "compensate/read_back/figures.hpp"
#include "compensate/read_back/intended.hpp"
#include "compensate/read_back/time_check.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::compensate {

class MoveCheck {
 public:
  /// All must outlive it; figures are added to. `time_tolerance`: share of a move's time that it may change by.
  MoveCheck(const nc::Dialect& dialect, double time_tolerance, ReadBackFigures& figures)
      : dialect_(dialect), figures_(figures), times_(dialect, time_tolerance) {}

  /// Both must stay until end().
  void begin(const IntendedBatch& batch, const IntendedBlock& block);
  /// The moves of a block of the output. Throws Difference.
  void take(const nc::Step& step);
  /// All moves of the block must have been made: something that comes after them does. Throws Difference.
  void end();
  /// A move was read since begin().
  bool has_moved() const { return has_moved_; }

 private:
  void take_motion(const nc::Motion& motion);
  bool take_kept(const IntendedMove& meant, const nc::Motion& motion);
  bool take_dwell(const IntendedMove& meant, const nc::Motion& motion);
  bool take_piece(const IntendedMove& meant, const nc::Motion& motion);
  void reach(const IntendedMove& meant, const AxisWords& wanted, const nc::Motion& motion);
  void go_to(const nc::Motion& motion);
  [[noreturn]] void differ(const nc::Motion& motion) const;
  void note_point(const IntendedMove& meant, const AxisWords& wanted, const nc::Motion& motion);
  bool is_reached(const IntendedMove& move, std::size_t point) const;
  bool may_finish(const IntendedMove& meant) const;
  void finish_move();
  void leave_move();

  const nc::Dialect& dialect_;
  ReadBackFigures& figures_;
  TimeCheck times_;
  const IntendedBatch* batch_ = nullptr;
  const IntendedBlock* block_ = nullptr;
  const nc::Step* step_ = nullptr;  // of the output
  std::size_t move_ = 0, last_move_ = 0;
  std::size_t point_ = 0;  // of the move, the next to be reached
  bool has_moved_ = false;
  bool stops_ = false;  // exactly, at the end of the last piece
  AxisWords stands_;    // the control's display
  AxisSet stands_known_;
};

}  // namespace plumbline::compensate
