// Words as they can be written, and as the control keeps them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
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

inline constexpr double kSamePlace = 1e-9;  // mm and deg

/// What can be said of the axes in the words of a step's block.
class WordGrid {
 public:
  WordGrid(const Dialect& dialect, const EmitSettings& settings) : dialect_(dialect), settings_(settings) {}

  struct Grid : WrittenNumber {  // of one axis
    double per_unit = 1;         // mm or deg per unit of the program
  };
  Grid grid(const Step& step, Axis axis) const;

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

  /// The word that sends an axis which turns without end to `to`, deg. Where it stands (`from`) may not be known: then
  /// the way round is the one that the original goes. Refuses with emit-rotary-word.
  double endless_word(const Step& step, Axis axis, double to, std::optional<double> from) const;

  /// Refuse with emit-out-of-range what cannot be written with all its digits, or is longer than the control takes.
  static void check_word(const Step& step, double value);
  void check_digits(const Step& step, double value, int decimals) const;

 private:
  bool keeps_time(const Step& step, const AxisWords& standing) const;
  static bool counts_turns(const Step& step, Axis axis);
  static bool depends_on_start(const Step& step, Axis axis);

  const Dialect& dialect_;
  const EmitSettings& settings_;
};

}  // namespace plumbline::nc
