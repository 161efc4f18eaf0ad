// Two programs at the level of poses: by how much the second moves the tool away from where the first does.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/axes.hpp"
#include "base/files/source.hpp"
#include "base/progress.hpp"
#include "compensate/recorded/drawn_path.hpp"
#include "compensate/summary.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// How far one axis is off.
struct AxisShift {
  double largest = 0;      // of the absolute values, mm or deg
  std::size_t line_a = 0;  // where
  std::size_t line_b = 0;
  double rms = 0;  // over all points
};

/// Moves that have no counterpart in the other program. 0: none of that side.
struct OutOfLine {
  std::size_t first_line_a = 0, last_line_a = 0;
  std::size_t first_line_b = 0, last_line_b = 0;
};

/// Cutting moves of A whose time, or that of their pieces, is not known: turns without a feed rule, G95, strokes
/// that a cycle makes in its own way.
struct UntimedMoves {
  std::uint64_t count = 0;
  std::size_t first_line = 0;

  void add(std::size_t line) {
    if (count++ == 0) first_line = line;
  }
};

struct DiffSummary {
  std::uint64_t moves_a = 0;
  std::uint64_t moves_b = 0;
  std::uint64_t matched = 0;  // moves of A that have their counterpart in B, whole or in pieces
  std::uint64_t points = 0;   // that were compared: ends of B's moves
  std::array<AxisShift, kAxes> shift;
  double seconds_a = 0;  // of cutting moves and dwells, those left out whose time is not known in both
  double seconds_b = 0;
  compensate::Worst time_change;  // of a move, as a share of its time in A; the line is A's
  UntimedMoves untimed;
  std::uint64_t out_of_line_a = 0;  // moves
  std::uint64_t out_of_line_b = 0;
  std::vector<OutOfLine> out_of_line;  // the first kMostListed places

  static constexpr std::size_t kMostListed = 1000;
  bool equal_within(double tolerance_mm, double tolerance_deg) const;
};

/// Aligns B's moves with A's, across subdivision: a move of A corresponds to one or more of B that lie along it and
/// lead to its end, moved by what the end before it was moved. What nobody gave (offsets, tools, start) is zero for
/// both. Memory does not grow with the length of the programs. Refuses what nc::Program refuses.
/// `picture`: A's path and where B's points are instead, without a machine; null: none is wanted.
DiffSummary diff_files(const Source& a, const Source& b, const settings::Options& options,
                       const Progress& progress = {}, compensate::DrawnPath* picture = nullptr);

}  // namespace plumbline::jobs
