// A move as the control will keep it: its points rounded to what can be written, each with its feed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/axes.hpp"
#include "nc/control/kept.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/emit_state.hpp"

namespace plumbline::nc {

/// How numbers are written and what the control keeps of them.
struct EmitSettings {
  int digits_mm = 4;
  int digits_deg = 5;
  int digits_inch = 6;
  double increment_mm = 0;  // what the control resolves; 0: whatever is written
  double increment_deg = 0;
  double increment_ratio = 1;           // --input-increment over the dialect's own
  double time_tolerance = 1e-3;         // F is written only where a block's time would change by more than this share
  std::vector<std::string> stamp;       // texts of the comments that mark the output
  std::vector<std::string> guard = {};  // whole lines behind the stamp
};

/// One point of a corrected move, in the active work system.
struct CorrectedPoint {
  AxisWords nominal;  // on the original path
  AxisWords shift;    // to be added, mm and deg
  double share = 1;   // of the block's time that ends here; all of a block add up to 1
};

/// One block of the output.
struct Piece {
  AxisWords value;                  // to be written: position, or increment under G91; in the program's unit
  std::array<int, kAxes> digits{};  // decimals of each
  AxisSet moved;                    // axes whose word must be written
  AxisSet endless;                  // axes whose absolute words count turns: those that do not move get no word
  bool direct = false;              // their words are written as A=DC(5)
  double share = 0;
  double length = 0;                 // that the feed is the speed along, in the program's unit or deg
  bool in_degrees = false;           // it is deg
  std::optional<double> feed;        // F to be written
  bool leaves_inverse_time = false;  // under G94 although the original is under G93
  bool restates_mode = false;        // its feed mode differs from the one before it
};

/// Turns points into pieces. Reused from block to block.
class PiecePlanner {
 public:
  PiecePlanner(const Dialect& dialect, const EmitSettings& settings) : dialect_(dialect), settings_(settings) {}

  /// True if the block may stay as it stands: every shift rounds to zero, and the control stands where the block takes
  /// it to stand.
  bool stays(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
             const OutputState& control) const;

  /// True if a shift is none, as the words of the block are written, in every axis that may be.
  bool rounds_to_zero(const Step& step, const AxisWords& shift, AxisSet writable) const;

  /// A word of the program's unit as it can be written and kept.
  double rounded(const Step& step, Axis axis, double value) const;
  /// A word that says where the axis stands: what is rounded away there would be an offset from then on.
  double offset_word(const Step& step, Axis axis, double value) const;

  /// The pieces of a move; control is left as after the last of them. Pieces in which nothing moves are joined.
  std::span<Piece> plan(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                        std::optional<double> seconds, OutputState& control);

  /// Of the last plan(): its pieces, and where the control stands after each, work system, mm and deg.
  std::span<const Piece> pieces() const { return pieces_; }
  std::span<const AxisWords> ends() const { return ends_; }
  double rounding_mm() const { return rounding_mm_; }
  std::optional<double> seconds() const { return seconds_; }

 private:
  struct Grid : WrittenNumber {  // of one axis
    double per_unit = 1;         // mm or deg per unit of the program
  };
  Grid grid(const Step& step, Axis axis) const;
  bool keeps_time(const Step& step, const AxisWords& standing) const;
  static bool counts_turns(const Step& step, Axis axis);
  static bool depends_on_start(const Step& step, Axis axis);
  double endless_word(const Step& step, Axis axis, double to, std::optional<double> from) const;
  Piece rounded_piece(const Step& step, const CorrectedPoint& point, AxisSet writable, AxisWords& at);
  void check_digits(const Step& step, double value, int decimals) const;
  double inverse_time(const Step& step, double per_minute) const;
  void set_lengths(const Step& step, const AxisWords& start);
  void choose_feeds(const Step& step, double seconds, OutputState& control);
  double feed_in_force(const Piece& piece, const OutputState& control) const;
  void state_feed(const Step& step, Piece& piece, double feed, OutputState& control) const;
  void choose_rates(const Step& step, double seconds, OutputState& control);
  void choose_inverse_times(const Step& step, double seconds, OutputState& control);

  const Dialect& dialect_;
  const EmitSettings& settings_;
  std::array<Grid, kAxes> grid_{};
  std::vector<Piece> pieces_;
  std::vector<AxisWords> ends_;  // where the control stands after each piece, work system, mm and deg
  double rounding_mm_ = 0;
  std::optional<double> seconds_;
};

}  // namespace plumbline::nc
