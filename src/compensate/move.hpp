// A move of a program: what the original asks of the machine.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "base/axes.hpp"
#include "compensate/read_back/figures.hpp"
#include "compensate/target.hpp"
#include "nc/control/state/frame.hpp"
#include "nc/control/step.hpp"
#include "path/curve.hpp"

namespace plumbline::compensate {

/// The way of a move through W.
struct MovePath {
  path::Curve curve;  // in the work system
  nc::Frame frame;
  AxisWords added;  // to its poses: the error at the touch-off
  AxisSet at_zero;  // axes that are taken to stand at zero
  AxisSet fixed;    // axes that no correction may write: these, and on a tilted plane all rotary ones
  std::size_t line = 0;
  std::string_view file = {};  // of a subprogram that it stands in; empty: the program's own

  Target target(double fraction, std::optional<double> seconds) const { return target(curve.point(fraction), seconds); }
  Target target(const path::CurvePoint& point, std::optional<double> seconds) const;
  /// The pose of target().
  AxisWords pose(double fraction) const { return in_base_frame(curve.at(fraction)) + added; }
  /// A place of the work system, where the machine stands still.
  Target at_rest(const AxisWords& work) const;
  /// What the words of the work system say in W, the error at the touch-off left out: mm and deg.
  AxisWords in_base_frame(AxisWords work) const;
  SourceLine place() const { return {line, file}; }
  AxisSet writable() const { return AxisSet::all() - fixed; }
};

/// Of a move whose points are corrected together with those of the moves after it.
inline constexpr int kFewPieces = 16;

struct Move {
  const nc::Step* step = nullptr;  // whose block makes it
  const nc::Motion* motion = nullptr;
  MovePath path;
  std::optional<double> duration;  // path::duration: seconds, under G95 revolutions
  std::optional<double> seconds;   // by the clock: not known of rapids and under G95
  bool begin_known = true;         // where it begins is known; false of rapids alone
  int pieces = 1;        // MoveReader::divide: of a cut those that are corrected, of a rapid those of its chord
  bool widened = false;  // the control's block time made the pieces longer than the steps

  bool is_rapid() const { return motion->kind == nc::MotionKind::rapid; }
  /// Of the end of a piece, counted from 1.
  double fraction(int piece) const { return static_cast<double>(piece) / pieces; }
};

}  // namespace plumbline::compensate
