// The path that a program asks for, point by point, with the tool that is in the spindle there: for commands that look
// at a program and leave it as it is.
#pragma once

#include <functional>

#include "base/files.hpp"
#include "base/progress.hpp"
#include "compensate/program_pose.hpp"
#include "machine/model.hpp"
#include "nc/sequence/program.hpp"
#include "path/subdivide.hpp"

namespace plumbline::jobs {

struct PathPoint {
  const nc::Step* step = nullptr;
  const nc::Motion* motion = nullptr;
  compensate::Target target;  // pose in W, slope along the move, seconds of the move; G95 and rapids: none
  std::optional<compensate::Target> way_from;  // where the rapid began that ends here, if that is known
  bool on_way = false;                         // of a rapid, before its end
  double time_s = 0;                           // since the start, rapids and dwells under G95 left out
};

class PathWalk {
 public:
  /// All references must outlive it. What is not set is not told.
  PathWalk(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
           const machine::MachineModel& model, const path::StepSettings& steps);

  std::function<void(const compensate::ToolInSpindle&)> on_tool;  // at the start, and when it changes
  std::function<void(AxisSet)> on_fixed_axes;                     // that no correction may write
  std::function<void(const PathPoint&)> on_point;

  /// Goes through the whole program. A feed move gives its points at the step settings, a rapid the points of its chord
  /// every 10 mm or 1 deg and its end; moves in machine coordinates and to unknown positions give none. Refuses what
  /// nc::Program refuses, and walk-position-unknown for feed moves from or to positions that are not known, and for
  /// axes that were taken to stand at zero and move.
  void run(const Progress& progress = {});

  /// A place in the work system of a step, at rest.
  compensate::Target target(const nc::Step& step, const AxisWords& words) const {
    return pose_.target(step, {words, {}, {}}, std::nullopt);
  }

  std::uint64_t blocks() const { return blocks_; }
  std::uint64_t passed_moves() const { return passed_moves_; }

 private:
  bool is_known(const nc::Step& step, const nc::Motion& motion);
  void walk_rapid(const nc::Step& step, const nc::Motion& motion);
  void walk_feed(const nc::Step& step, const nc::Motion& motion);

  const InputFile& source_;
  const nc::Dialect& dialect_;
  path::StepSettings steps_;
  nc::Program program_;
  compensate::SpindleTool spindle_;
  compensate::ProgramPose pose_;
  double time_s_ = 0;
  std::uint64_t blocks_ = 0;
  std::uint64_t passed_moves_ = 0;
};

}  // namespace plumbline::jobs
