// The F of the pieces of a move.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/axes.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/arc_words.hpp"
#include "nc/rewrite/output/emit_state.hpp"
#include "nc/rewrite/word_grid.hpp"

namespace plumbline::nc {

/// One block of the output.
struct Piece {
  AxisWords value;                  // to be written: position, or increment under G91; in the program's unit
  std::array<int, kAxes> digits{};  // decimals of each
  AxisSet moved;                    // axes whose word must be written
  std::optional<ArcWords> arc;      // nothing: straight
  AxisSet endless;                  // axes whose absolute words count turns: those that do not move get no word
  AxisSet positioned;               // under G91, written as X=AC(5)
  bool direct = false;              // their words are written as A=DC(5)
  double share = 0;
  double length = 0;                 // that the feed is the speed along, in the program's unit or deg
  bool in_degrees = false;           // it is deg
  std::optional<double> feed;        // F to be written
  bool leaves_inverse_time = false;  // under G94 although the original is under G93
  bool restates_mode = false;        // its feed mode differs from the one before it

  MotionMode mode(const Step& step) const {
    if (step.motions.front().kind == MotionKind::rapid) return MotionMode::rapid;
    return !arc ? MotionMode::feed : arc->arc.turns > 0 ? MotionMode::arc_ccw : MotionMode::arc_cw;
  }
};

/// The pieces of one move, which get their feeds.
class PieceFeeds {
 public:
  /// `start`, `ends`: where the control stands before them and after each, work system, mm and deg. All must outlive
  /// it.
  PieceFeeds(const Dialect& dialect, const EmitSettings& settings, const Step& step, std::span<Piece> pieces,
             std::span<const AxisWords> ends)
      : dialect_(dialect), settings_(settings), step_(step), pieces_(pieces), ends_(ends) {}

  /// Chooses them so that the move takes `seconds` (revolutions under G95), and returns what it takes; the control is
  /// left with the last. Refuses with emit-feed-rule and emit-feed-range.
  double choose(const AxisWords& start, double seconds, OutputState& control);
  /// A move whose time is not known keeps its F. Refuses with emit-feed-rule where the correction would change what
  /// that F means.
  void keep(bool has_time, OutputState& control) const;

 private:
  void set_lengths(const AxisWords& start);
  [[noreturn]] void refuse_feed(double feed) const;
  double rounded_feed(double feed) const;
  static double in_force(const Piece& piece, const OutputState& control);
  void state_feed(Piece& piece, double feed, OutputState& control) const;
  double lost_to_rounding() const;
  double choose_rates(double seconds, OutputState& control);
  double inverse_time(double per_minute) const;
  double choose_inverse_times(double seconds, OutputState& control);

  const Dialect& dialect_;
  const EmitSettings& settings_;
  const Step& step_;
  std::span<Piece> pieces_;
  std::span<const AxisWords> ends_;
  bool in_the_middle_ = false;  // lengths are between those of the rules that F may follow
};

}  // namespace plumbline::nc
