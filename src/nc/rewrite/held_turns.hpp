// Turns of a correction that wait: where no source says which speed F is in a block that moves and turns.
#pragma once

#include <span>
#include <vector>

#include "base/axes.hpp"
#include "nc/control/step.hpp"
#include "nc/rewrite/output/emit_settings.hpp"
#include "nc/rewrite/word_grid.hpp"

namespace plumbline::nc {

inline constexpr double kMostHeldDeg = 0.01;  // off the orientation that the correction asks for

/// The points of a move in which the program turns nothing, its correction with so little turning beside its way that
/// the time of the block is the same under every rule, but for EmitSettings::time_tolerance: A, B and C stay behind
/// where they turn more, and follow as the way allows, in this move and in those after it. X, Y and Z stay as they are.
class HeldTurns {
 public:
  explicit HeldTurns(const EmitSettings& settings) : settings_(settings) {}

  /// The points themselves where nothing has to wait, where the rule is known, or where the tool would stand more than
  /// 0.01 deg off. `start`: where the control stands, work system, mm and deg. Holds until the next call.
  std::span<const CorrectedPoint> hold(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                                       const AxisWords& start, const WordGrid::AxisGrids& grids);

 private:
  bool applies(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable) const;

  const EmitSettings& settings_;
  std::vector<CorrectedPoint> held_;
};

}  // namespace plumbline::nc
