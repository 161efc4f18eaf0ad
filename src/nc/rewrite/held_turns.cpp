#include "nc/rewrite/held_turns.hpp"

#include <algorithm>
#include <cmath>

#include "nc/rewrite/feed.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSparing = 0.98;  // of what may be used: pieces are rounded once more where they are written

constexpr std::array kRotary{Axis::A, Axis::B, Axis::C};

double length_deg(const AxisWords& delta) { return std::hypot(delta[Axis::A], delta[Axis::B], delta[Axis::C]); }

AxisWords rounded(const Step& step, const AxisWords& target, const AxisWords& at, const WordGrid::AxisGrids& grids) {
  AxisWords end;
  for (const Axis axis : kAllAxes) {
    const WordGrid::Grid& g = *grids[index(axis)];
    const double from = step.after->incremental ? at[axis] : 0;
    end[axis] = from + g.kept((target[axis] - from) / g.per_unit) * g.per_unit;
  }
  return end;
}

// The part of a turn, in whole steps of each axis, that is no larger than `most`.
AxisWords part_of_turn(const AxisWords& turn, double most, const WordGrid::AxisGrids& grids) {
  const double whole = length_deg(turn);
  if (whole <= most) return turn;
  AxisWords part;
  for (const Axis axis : kRotary) {
    const WordGrid::Grid& g = *grids[index(axis)];
    const double step = g.quantum * g.per_unit;
    part[axis] = std::trunc(turn[axis] * most / whole / step) * step;
  }
  return part;
}

// How much longer a way is where degrees count as units of the program, mm; of a turn alone they count the same.
double added_by_turn(double mm, double deg, double mm_per_unit) {
  return mm > 0 ? std::hypot(mm, deg * mm_per_unit) - mm : 0;
}

}  // namespace

bool HeldTurns::applies(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable) const {
  const Motion& motion = step.motions.front();
  const bool cuts = motion.kind == MotionKind::feed || motion.kind == MotionKind::arc;
  if (!cuts || motion.feed_rule != FeedRule::unknown || motion.feed_mode == FeedMode::inverse_time) return false;
  if (settings_.keep_piece_times) return false;  // each piece was proven as it is
  for (const Axis axis : kRotary) {
    const bool stays = motion.to[axis] == motion.from[axis] && step.after->rule_of(axis) == RotaryRule::linear;
    if (!stays || !motion.known_before.contains(axis) || !writable.contains(axis)) return false;
  }
  return std::none_of(points.begin(), points.end(), [](const CorrectedPoint& point) { return point.arc.has_value(); });
}

std::span<const CorrectedPoint> HeldTurns::hold(const Step& step, std::span<const CorrectedPoint> points,
                                                AxisSet writable, const AxisWords& start,
                                                const WordGrid::AxisGrids& grids) {
  if (!applies(step, points, writable)) return points;
  const double unit = step.motions.front().mm_per_unit;
  double way = 0;
  double added = 0;
  AxisWords at = start;
  for (const CorrectedPoint& point : points) {
    const AxisWords end = rounded(step, point.nominal + point.shift, at, grids);
    way += length_mm(end - at);
    added += added_by_turn(length_mm(end - at), length_deg(end - at), unit);
    at = end;
  }
  if (added <= settings_.time_tolerance * way) return points;

  double left = kSparing * settings_.time_tolerance * way;
  held_.assign(points.begin(), points.end());
  at = start;
  for (CorrectedPoint& point : held_) {
    const AxisWords wanted = point.nominal + point.shift;
    AxisWords end = rounded(step, wanted, at, grids);
    const double mm = length_mm(end - at);
    // hypot(mm, deg * unit) - mm = left
    const double most = mm > 0 ? std::sqrt(left * (left + 2 * mm)) / unit : 0;
    const AxisWords turn = part_of_turn(end - at, most, grids);
    for (const Axis axis : kRotary) {
      end[axis] = at[axis] + turn[axis];
      point.shift[axis] = end[axis] - point.nominal[axis];
    }
    if (length_deg(wanted - end) > kMostHeldDeg) return points;
    left = std::max(0.0, left - added_by_turn(mm, length_deg(end - at), unit));
    at = end;
  }
  return held_;
}

}  // namespace plumbline::nc
