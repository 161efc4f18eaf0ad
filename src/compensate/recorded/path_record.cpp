#include "compensate/recorded/path_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "machine/inverse.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double least_room(const machine::Limits& limits, const machine::PerStrut<double>& lengths) {
  return std::min((lengths - limits.length_min).minCoeff(), (limits.length_max - lengths).minCoeff());
}

RecordedPoint recorded_point(const MovePath& path, WayKind kind, double fraction, std::optional<double> seconds,
                             double begin_s) {
  RecordedPoint point;
  point.kind = kind;
  point.line = path.line;
  point.time_s = begin_s + fraction * seconds.value_or(0);
  point.asked = kind == WayKind::rapid ? path.at_rest(path.curve.at(fraction)) : path.target(fraction, seconds);
  if (seconds && *seconds > 0) point.mm_s = length_mm(point.asked.slope) / *seconds;
  return point;
}

void PathRecord::set_tool(const ToolInSpindle& tool, int number) {
  settle();
  if (machine_) machine_->set_tool(tool);
  tool_ = tool;
  number_ = number;
}

void PathRecord::restart() {
  waiting_.clear();
  texts_.clear();
  points_.clear();
  if (machine_) machine_.emplace(*model_, *settings_);
  tool_.reset();
  number_ = -1;
  gap_ = true;
}

std::vector<RecordedPoint> PathRecord::take() {
  settle();
  return points_.take();
}

void PathRecord::add(RecordedPoint point, const Texts& texts) {
  if (std::exchange(gap_, false)) point.kind = WayKind::gap;
  Waiting& waiting = waiting_.emplace_back(Waiting{std::move(point)});
  waiting.before = texts_.size();
  texts_ += texts.before.substr(0, kMostText);
  waiting.after = texts_.size();
  texts_ += texts.after.substr(0, kMostText);
  waiting.file = texts_.size();
  texts_ += texts.file;
  waiting.end = texts_.size();
  if (waiting_.size() == kWaiting) settle();
}

// The loads are taken where the machine is sent to: a few hundred um away they are the same to a millionth.
void PathRecord::settle() {
  if (waiting_.empty()) return;
  if (machine_) {
    batch_.clear();
    for (const Waiting& waiting : waiting_) {
      const RecordedPoint& point = waiting.point;
      batch_.add(point.commanded, point.asked.slope, point.asked.bend, point.asked.seconds.value_or(-1));
    }
    machine_->carry(batch_);
  }
  figures_.clear();
  for (std::size_t i = 0; i < waiting_.size(); ++i) figures_.push_back(figures_of(waiting_[i].point, load_of(i)));
  points_.add(figures_, [&](std::size_t i) { return kept(waiting_[i]); });
  waiting_.clear();
  texts_.clear();
}

PathRecord::Load PathRecord::load_of(std::size_t waiting) const {
  Load load;
  if (!machine_) return load;
  LoadedMachine::Carried carried;
  if (const RecordedPoint& point = waiting_[waiting].point; batch_.carries(waiting) && !point.asked.sign) {
    carried = {batch_.length(waiting), batch_.nut_tension(waiting)};
  } else {
    Target told = point.asked;
    told.pose = point.commanded;
    carried = machine_->carried(machine_->motion(told));
  }
  load.room = least_room(model_->limits, carried.lengths);
  if (carried.singular) return load;
  load.least_tension = carried.nut_tension.minCoeff();
  load.largest_tension = carried.nut_tension.maxCoeff();
  return load;
}

PathRecord::Points::Figures PathRecord::figures_of(const RecordedPoint& point, const Load& load) {
  const AxisWords correction = point.commanded - point.asked.pose;
  const AxisWords& at = point.commanded;
  return {at[Axis::X],
          at[Axis::Y],
          at[Axis::Z],
          at[Axis::A],
          at[Axis::B],
          at[Axis::C],
          length_mm(correction),
          path::largest_turn_deg(correction),
          point.mm_s.value_or(kNone),
          point.piece_s.value_or(kNone),
          load.room,
          load.least_tension,
          load.largest_tension};
}

RecordedPoint PathRecord::kept(Waiting& waiting) const {
  RecordedPoint point = std::move(waiting.point);
  point.tool = number_;
  point.in_spindle = tool_;
  point.text = texts_.substr(waiting.before, waiting.after - waiting.before);
  point.after = texts_.substr(waiting.after, waiting.file - waiting.after);
  point.file = texts_.substr(waiting.file, waiting.end - waiting.file);
  return point;
}

}  // namespace plumbline::compensate
