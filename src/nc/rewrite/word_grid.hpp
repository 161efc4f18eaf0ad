// Words as they can be written, and as the control keeps them.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/axes.hpp"
#include "base/text/number_text.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/control/state/motion.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/output/emit_settings.hpp"
#include "nc/rewrite/output/emit_state.hpp"

namespace plumbline::nc {

/// One point of a corrected move, in the active work system.
struct CorrectedPoint {
  AxisWords nominal;            // on the original path
  AxisWords shift;              // to be added, mm and deg
  double share = 1;             // of the block's time that ends here; all of a block add up to 1
  std::optional<Arc> arc = {};  // that leads here, as it shall be told; nothing: straight
};

inline constexpr double kSamePlace = 1e-9;  // mm and deg
inline constexpr double kMovesFrom = 0.25;  // of a quantum: less is the noise of adding and taking away offsets

/// What can be said of the axes in the words of a step's block.
class WordGrid {
 public:
  /// Both must outlive it, and stay as they are.
  WordGrid(const Dialect& dialect, const EmitSettings& settings);

  struct Grid : WrittenNumber {  // of one axis
    double per_unit = 1;         // mm or deg per unit of the program
  };
  using AxisGrids = std::array<const Grid*, kAxes>;
  AxisGrids grids(const Step& step) const;
  /// Of the word that gives the centre of an arc along an axis.
  const Grid& centre_grid(const Step& step, Axis axis) const;

  /// True if the block may stay as it stands: every shift rounds to zero, and the control stands where the block takes
  /// it to stand.
  bool stays(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
             const OutputState& control) const;

  /// What rounding may take off a word of the step's move, or put on it, mm and deg: half a quantum. An axis that
  /// stands between two words is left there where it is nearer than kMovesFrom of a quantum to the next.
  AxisWords half_quanta(const Step& step, const OutputState& control) const;

  /// True if a shift is none, as the words of the block are written, in every axis that may be.
  bool rounds_to_zero(const Step& step, const AxisWords& shift, AxisSet writable) const;

  /// A word of the program's unit as it can be written and kept.
  double rounded(const Step& step, Axis axis, double value) const;
  /// A word that says where the axis stands: what is rounded away there would be an offset from then on.
  double offset_word(const Step& step, Axis axis, double value) const;

  /// The word that sends an axis which turns without end to `to`, deg. Where it stands may not be known: then the way
  /// round is the one that the original goes, from where it was left as well. Refuses with emit-rotary-word.
  double endless_word(const Step& step, Axis axis, double to, double left_at, bool is_known) const;

  /// Refuse with emit-out-of-range what cannot be written with all its digits, or is longer than the control takes.
  static void check_word(const Step& step, double value) {
    if (!(std::abs(value) < kLargestWord)) refuse_word(step, value);
  }
  void check_digits(const Step& step, double value, int decimals) const {
    if (most_digits_ > 0) count_digits(step, value, decimals);
  }

 private:
  static constexpr double kLargestWord = 1e6;  // with nine decimals this still is exact in a double
  [[noreturn]] static void refuse_word(const Step& step, double value);
  void count_digits(const Step& step, double value, int decimals) const;
  static constexpr std::size_t kind(bool rotary, bool inches, bool incremental) {
    return (rotary ? 4U : 0U) + (inches ? 2U : 0U) + (incremental ? 1U : 0U);
  }
  const Grid& grid(const Step& step, Axis axis, const Word* word) const;
  bool keeps_time(const Step& step, const AxisWords& standing) const;
  static void refuse_way_round(const Step& step, Axis axis, RotaryRule rule, double word, double written,
                               double left_at);
  static bool counts_turns(const Step& step, Axis axis);
  static bool depends_on_start(const Step& step, Axis axis);

  const Dialect& dialect_;
  const EmitSettings& settings_;
  int most_digits_;                                             // of a word; 0: any
  std::array<std::array<Grid, kMostDecimals + 1>, 8> grids_{};  // by kind(), and by the decimals of the word
};

}  // namespace plumbline::nc
