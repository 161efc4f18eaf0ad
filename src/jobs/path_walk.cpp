#include "jobs/path_walk.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "compensate/guard.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"

namespace plumbline::jobs {
namespace {

bool cuts(const nc::Motion& motion) {
  return motion.kind == nc::MotionKind::feed || motion.kind == nc::MotionKind::arc;
}

}  // namespace

PathWalk::PathWalk(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
                   const machine::MachineModel& model, const path::StepSettings& steps)
    : source_(source),
      dialect_(dialect),
      steps_(steps),
      program_(source, dialect, program),
      spindle_(program.tools, model.reference_tool_mass),
      pose_(source, dialect) {}

void PathWalk::run(const Progress& progress) {
  pose_.on_fixed = on_fixed_axes;
  while (const nc::Step* step = program_.next()) {
    ++blocks_;
    pose_.take(*step);
    if (const auto tool = spindle_.change(*step); tool && on_tool) on_tool(*tool);
    for (const nc::Motion& motion : step->motions) {
      if (motion.kind == nc::MotionKind::dwell) {
        time_s_ += motion.dwell_s;
      } else if (!is_known(*step, motion)) {
        ++passed_moves_;
      } else if (cuts(motion)) {
        walk_feed(*step, motion);
      } else {
        walk_rapid(*step, motion);
      }
    }
    if (progress && blocks_ % kProgressEvery == 0) progress(step->block->offset, source_.size());
  }
}

bool PathWalk::is_known(const nc::Step& step, const nc::Motion& motion) {
  if (motion.in_machine_coordinates || motion.kind == nc::MotionKind::probe) return false;
  if (!(pose_.assumed() & step.named).empty()) {
    refuse("walk-position-unknown",
           "an axis was taken to stand at zero, since the program's own file never names it, and moves here",
           "say where the machine stands with --start", compensate::place_of(*step.block, step.block->file));
  }
  const AxisSet known = cuts(motion) ? motion.known_after & motion.known_before : motion.known_after;
  const AxisSet unknown = AxisSet::all() - known;
  const AxisSet missing = unknown - pose_.assumed(step, unknown);
  if (missing.empty()) return true;
  if (!cuts(motion)) return false;
  refuse("walk-position-unknown", "this move cuts, and where some axis stands is not known here",
         "move all axes with G0 to a stated position first, or say where the machine stands: --start at the begin, "
         "--keeps-position M6 after a tool change",
         compensate::place_of(*step.block, step.block->file));
}

void PathWalk::walk_rapid(const nc::Step& step, const nc::Motion& motion) {
  const AxisSet needed = AxisSet::all() - pose_.assumed();
  const AxisWords delta = motion.to - motion.from;
  const bool start_known = motion.known_before.contains(needed);
  const int count = start_known ? compensate::chord_steps(delta) : 1;
  for (int i = 1; i <= count; ++i) {
    AxisWords words = motion.to;
    for (const Axis axis : kAllAxes) {
      if (i < count) words[axis] = motion.from[axis] + delta[axis] * i / count;
    }
    PathPoint point{&step, &motion, target(step, words), std::nullopt, i < count, time_s_};
    if (i == count && start_known) point.way_from = target(step, motion.from);
    on_point(point);
  }
}

void PathWalk::walk_feed(const nc::Step& step, const nc::Motion& motion) {
  const path::Curve curve(motion);
  std::optional<double> seconds = path::duration(motion, curve, dialect_);
  if (motion.feed_mode == nc::FeedMode::per_revolution) seconds.reset();  // the spindle's to say
  const int pieces =
      path::subdivide(curve, seconds, steps_, compensate::place_of(*step.block, step.block->file)).pieces;
  const double begin = time_s_;
  for (int i = 1; i <= pieces; ++i) {
    const double fraction = static_cast<double>(i) / pieces;
    time_s_ = begin + fraction * seconds.value_or(0);
    on_point({&step, &motion, pose_.target(step, curve.point(fraction), seconds), std::nullopt, false, time_s_});
  }
}

}  // namespace plumbline::jobs
