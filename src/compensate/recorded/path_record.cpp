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
  if (machine_) machine_->set_tool(tool);
  tool_ = tool;
  number_ = number;
}

void PathRecord::restart() {
  points_.clear();
  if (machine_) machine_.emplace(*model_, *settings_);
  tool_.reset();
  number_ = -1;
  gap_ = true;
}

PathRecord::Load PathRecord::load_at(const RecordedPoint& point) const {
  Load load;
  if (!machine_) return load;
  Target told = point.asked;
  told.pose = point.commanded;
  // The loads are taken where the machine is sent to: a few hundred um away they are the same to a millionth.
  const physics::Motion<double> motion = machine_->motion(told);
  const LoadedMachine::Carried loads = machine_->carried(motion);
  load.room = least_room(model_->limits, loads.lengths);
  if (loads.singular) return load;
  load.least_tension = loads.nut_tension.minCoeff();
  load.largest_tension = loads.nut_tension.maxCoeff();
  return load;
}

void PathRecord::add(RecordedPoint point, const std::function<Texts()>& texts) {
  if (std::exchange(gap_, false)) point.kind = WayKind::gap;
  const Load load = load_at(point);
  const AxisWords correction = point.commanded - point.asked.pose;
  const AxisWords& at = point.commanded;
  points_.add({at[Axis::X], at[Axis::Y], at[Axis::Z], at[Axis::A], at[Axis::B], at[Axis::C], length_mm(correction),
               path::largest_turn_deg(correction), point.mm_s.value_or(kNone), point.piece_s.value_or(kNone), load.room,
               load.least_tension, load.largest_tension},
              [&] {
                point.tool = number_;
                point.in_spindle = tool_;
                const Texts said = texts();
                point.text = said.before.substr(0, kMostText);
                point.after = said.after.substr(0, kMostText);
                return std::move(point);
              });
}

}  // namespace plumbline::compensate
