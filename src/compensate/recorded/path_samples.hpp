// Points of the cuts of a program, few of many, to look at more closely when it has been read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compensate/corrector.hpp"
#include "compensate/move.hpp"
#include "compensate/recorded/decimated.hpp"

namespace plumbline::compensate {

struct PathSample {
  std::size_t line = 0;
  std::string file;                         // as SourceLine has it
  double time_s = 0;                        // of cuts, since the start
  Target target;                            // in W, as the original means it
  std::optional<ToolInSpindle> in_spindle;  // nothing: none came into it, the model has its own
};

/// Takes the ways of all cuts and keeps points of them: of each stretch the first, and those where an axis is at an
/// extreme, or within a 64th of the stretch's range. Memory does not grow with the program.
class PathSamples {
 public:
  /// At most some ten times as many points as `stretches`.
  explicit PathSamples(std::size_t stretches = 24) : points_(stretches, 1, 1.0 / 64) {}

  void set_tool(const ToolInSpindle& tool) { tool_ = tool; }
  /// A move that cuts, at the ends of its pieces.
  void add(const Move& move, std::size_t pieces);
  void restart();

  std::vector<PathSample> take() { return points_.take(); }

 private:
  static constexpr std::size_t kMostOfMove = 24;

  std::optional<ToolInSpindle> tool_;
  double time_s_ = 0;
  Decimated<PathSample, 6> points_;
};

}  // namespace plumbline::compensate
