// A program compensated by a bound, and its output played densely: on which pieces the bound is not kept.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/dense_play.hpp"
#include "compensate/play.hpp"

namespace plumbline {

inline constexpr int kDense = 50;  // points of a piece

inline Job job_within(double tolerance_um, bool friction) {
  Job job;
  job.settings.friction = friction;
  job.settings.bound.tolerance_mm = tolerance_um * 1e-3;
  job.settings.bound.least_time_s = 1.002e-3;  // F may change the time by 0.1 %
  return job;
}

struct HeldBound {
  Result result;
  DensePlay played;
  std::uint64_t over = 0;            // pieces of the output on which the played tip is further off
  double over_s = 0;                 // that these take
  double worst_um = 0;               // on them
  std::uint64_t short_pieces = 0;    // of less than a millisecond, where the program's own block is longer
  double kept_um = 0, kept_deg = 0;  // on the others
  /// The output takes another time than the original, so that its pieces cannot be put beside the original's moves: a
  /// block that goes nowhere goes some micrometres, at the F that happens to be in force.
  bool drifted = false;

  std::uint64_t said_over() const {
    return result.summary.bound->at_turns.pieces + result.summary.bound->by_time.pieces;
  }
  double said_over_s() const { return result.summary.bound->at_turns.seconds + result.summary.bound->by_time.seconds; }
  double said_worst_um() const {
    const compensate::BoundFigures& bound = *result.summary.bound;
    return std::max(bound.at_turns.off_mm.value, bound.by_time.off_mm.value) * 1e3;
  }
};

inline HeldBound held_bound(const std::string& text, const Job& job, int per_piece,
                            const compensate::ToolInSpindle& tool = {}) {
  HeldBound held;
  held.result = run(text, job);
  held.played = dense_play(text, held.result.text, job, per_piece, tool);
  const double tolerance_um = job.settings.bound.tolerance_mm * 1e3;
  const double tolerance_deg = job.settings.bound.tolerance_mm / 100 / kDeg;
  for (const PlayedPiece& piece : held.played.pieces) {
    if (piece.tip_um <= tolerance_um && piece.turned_deg <= tolerance_deg) {
      held.kept_um = std::max(held.kept_um, piece.tip_um);
      held.kept_deg = std::max(held.kept_deg, piece.turned_deg);
      continue;
    }
    ++held.over;
    held.over_s += piece.seconds;
    held.worst_um = std::max(held.worst_um, piece.tip_um);
  }
  const auto count = [](const std::vector<dense::Timed>& moves) {
    return std::count_if(moves.begin(), moves.end(), [](const dense::Timed& move) {
      return move.end - move.begin > 0 && move.end - move.begin < 1e-3 * (1 - 1e-6);
    });
  };
  const nc::Dialect& dialect = nc::dialect(job.dialect);
  const std::vector<dense::Timed> before = dense::timed(moves_of(text, job.program, job.dialect), dialect);
  const std::vector<dense::Timed> after = dense::timed(moves_of(held.result.text, job.program, job.dialect), dialect);
  held.short_pieces = static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(0, count(after) - count(before)));
  held.drifted = std::abs(after.back().end / before.back().end - 1) > 3e-3;
  return held;
}

// It is not kept on more pieces than the summary says, nor for longer, nor by more.
inline void check_held(const HeldBound& held, const std::string& text) {
  INFO(text);
  INFO(held.over << " pieces of " << held.played.pieces.size() << " over for " << held.over_s << " s, up to "
                 << held.worst_um << " um; said " << held.said_over() << " for " << held.said_over_s() << " s, up to "
                 << held.said_worst_um());
  CHECK(held.short_pieces == 0);
  CHECK(held.over <= held.said_over());
  CHECK(held.over_s <= held.said_over_s() * 1.01);
  CHECK(held.worst_um <= held.said_worst_um() * 1.01);
}

}  // namespace plumbline
