#include "jobs/path_walk.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "compensate/guard.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"

namespace plumbline::jobs {
namespace {

constexpr double kChordStepMm = 10;
constexpr double kChordStepDeg = 1;

bool cuts(const nc::Motion& motion) {
  return motion.kind == nc::MotionKind::feed || motion.kind == nc::MotionKind::arc;
}

int chord_steps(const AxisWords& delta) {
  const double length = std::hypot(delta[Axis::X], delta[Axis::Y], delta[Axis::Z]);
  const double turn = std::max({std::abs(delta[Axis::A]), std::abs(delta[Axis::B]), std::abs(delta[Axis::C])});
  return std::max(1, static_cast<int>(std::ceil(std::max(length / kChordStepMm, turn / kChordStepDeg))));
}

}  // namespace

PathWalk::PathWalk(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
                   const machine::MachineModel& model, const path::StepSettings& steps)
    : source_(source),
      dialect_(dialect),
      settings_(program),
      model_(model),
      steps_(steps),
      program_(source, dialect, program) {}

void PathWalk::run(const Progress& progress) {
  while (const nc::Step* step = program_.next()) {
    ++blocks_;
    take_tool(*step);
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

// Length (G43) and load (M6) of the tool.
void PathWalk::take_tool(const nc::Step& step) {
  const AxisWords& offset = step.frame->tool;
  const int tool = step.after->tool_in_spindle;
  if (tool_offset_ == offset && tool == tool_in_spindle_) return;
  tool_offset_ = offset;
  tool_in_spindle_ = tool;
  const nc::Tool* const row = tool >= 0 ? settings_.tools.find(tool) : nullptr;
  compensate::ToolInSpindle in_spindle{offset[Axis::Z] * kMm, model_.reference_tool_mass, 0};
  if (row != nullptr && row->mass_kg) {
    in_spindle.mass = *row->mass_kg;
    in_spindle.along = row->centre_of_mass_mm.value_or(0) * kMm;
  }
  if (on_tool) on_tool(in_spindle);
}

bool PathWalk::is_known(const nc::Step& step, const nc::Motion& motion) {
  if (motion.in_machine_coordinates || motion.kind == nc::MotionKind::probe) return false;
  const AxisSet known = cuts(motion) ? motion.known_after & motion.known_before : motion.known_after;
  const AxisSet unknown = AxisSet::all() - known;
  const AxisSet missing = unknown - assumed_of(step, unknown);
  if (missing.empty()) return true;
  if (!cuts(motion)) return false;
  refuse("walk-position-unknown", "this move cuts, and where some axis stands is not known here",
         "move all axes with G0 to a stated position first, or say where the machine stands: --start at the begin, "
         "--keeps-position M6 after a tool change",
         compensate::place_of(*step.block, step.block->file));
}

// Rotary axes that no word of the program names are taken to stand at zero, unless the work offset turns them.
AxisSet PathWalk::assumed_of(const nc::Step& step, AxisSet unknown) {
  if (assumed_ && !(*assumed_ & step.named).empty()) {
    refuse("walk-position-unknown",
           "an axis was taken to stand at zero, since the program's own file never names it, and moves here",
           "say where the machine stands with --start", compensate::place_of(*step.block, step.block->file));
  }
  if ((unknown & AxisSet::rotary()).empty()) return {};
  if (!assumed_) {
    assumed_ = AxisSet::rotary() - nc::named_axes(source_, dialect_);
    if (on_assumed_axes) on_assumed_axes(*assumed_);
  }
  AxisSet assumed = unknown & *assumed_;
  for (const Axis axis : kAllAxes) {
    if (step.frame->to_pose({})[axis] != 0) assumed.erase(axis);
  }
  return assumed;
}

compensate::Target PathWalk::target_of(const nc::Step& step, const AxisWords& words, const AxisWords& slope,
                                       std::optional<double> seconds) const {
  AxisWords work = words;
  for (const Axis axis : kAllAxes) {
    if (assumed_ && assumed_->contains(axis)) work[axis] = 0;
  }
  nc::Frame turned;
  turned.rotation_deg = step.frame->rotation_deg;
  return {step.frame->to_pose(work), turned.to_pose(slope), seconds};
}

void PathWalk::walk_rapid(const nc::Step& step, const nc::Motion& motion) {
  const AxisSet needed = AxisSet::all() - assumed_.value_or(AxisSet{});
  const AxisWords delta = motion.to - motion.from;
  const int count = motion.known_before.contains(needed) ? chord_steps(delta) : 1;
  for (int i = 1; i <= count; ++i) {
    AxisWords words = motion.to;
    for (const Axis axis : kAllAxes) {
      if (i < count) words[axis] = motion.from[axis] + delta[axis] * i / count;
    }
    on_point({&step, &motion, target_of(step, words, {}, std::nullopt), time_s_});
  }
}

void PathWalk::walk_feed(const nc::Step& step, const nc::Motion& motion) {
  const path::Curve curve(motion);
  std::optional<double> seconds = path::duration(motion, curve, dialect_);
  if (motion.feed_mode == nc::FeedMode::per_revolution) seconds.reset();  // the spindle's to say
  const int pieces = path::subdivide(curve, seconds, steps_).pieces;
  const double begin = time_s_;
  for (int i = 1; i <= pieces; ++i) {
    const double fraction = static_cast<double>(i) / pieces;
    time_s_ = begin + fraction * seconds.value_or(0);
    on_point({&step, &motion, target_of(step, curve.at(fraction), curve.slope(fraction), seconds), time_s_});
  }
}

}  // namespace plumbline::jobs
