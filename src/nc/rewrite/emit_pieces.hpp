// A move as the control will keep it: its points rounded to what can be written, each with its feed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/axes.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/held_turns.hpp"
#include "nc/rewrite/output/emit_state.hpp"
#include "nc/rewrite/piece_feeds.hpp"
#include "nc/rewrite/word_grid.hpp"

namespace plumbline::nc {

/// Turns points into pieces. Reused from block to block.
class PiecePlanner {
 public:
  PiecePlanner(const Dialect& dialect, const EmitSettings& settings)
      : dialect_(dialect), settings_(settings), words_(dialect, settings), held_(settings) {}

  const WordGrid& words() const { return words_; }

  /// The pieces of a move; control is left as after the last of them. Pieces in which nothing moves are joined, and
  /// A, B, C may wait (HeldTurns).
  std::span<Piece> plan(const Step& step, std::span<const CorrectedPoint> asked, AxisSet writable,
                        std::optional<double> seconds, OutputState& control);

  /// Of the last plan(): the points that it wrote,
  std::span<const CorrectedPoint> points() const { return points_; }
  /// its pieces, and where the control stands after each, work system, mm and deg.
  std::span<const Piece> pieces() const { return pieces_; }
  std::span<const AxisWords> ends() const { return ends_; }
  double rounding_mm() const { return rounding_mm_; }
  std::optional<double> seconds() const { return seconds_; }

 private:
  void round_each(const Step& step, AxisSet writable, const AxisWords& start);
  void round_joined(const Step& step, AxisSet writable, const AxisWords& start);
  void round_last_again(const Step& step, AxisSet writable, const AxisWords& start);
  void hold_turn(const Step& step, AxisSet writable, const AxisWords& start);
  void round(const Step& step, const CorrectedPoint& point, AxisSet writable, Piece& piece, AxisWords& at);

  const Dialect& dialect_;
  const EmitSettings& settings_;
  WordGrid words_;
  HeldTurns held_;
  std::span<const CorrectedPoint> points_;
  std::vector<CorrectedPoint> joined_;  // those of round_joined() that became the end of a piece
  WordGrid::AxisGrids grids_{};
  std::vector<Piece> pieces_;
  std::vector<AxisWords> ends_;  // where the control stands after each piece, work system, mm and deg
  double rounding_mm_ = 0;
  std::optional<double> seconds_;
};

}  // namespace plumbline::nc
