// Figures of moves and positions that many look at.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/axes.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::path {

inline double largest_turn_deg(const AxisWords& d) {
  return std::max({std::abs(d[Axis::A]), std::abs(d[Axis::B]), std::abs(d[Axis::C])});
}

inline bool is_cut(nc::MotionKind kind) { return kind == nc::MotionKind::feed || kind == nc::MotionKind::arc; }

/// True of a move, as far as it is known, to where the axes stand already.
inline bool stands(const nc::Motion& motion) {
  if (motion.kind == nc::MotionKind::dwell || motion.kind == nc::MotionKind::arc) return false;
  if (!motion.known_before.contains(motion.known_after)) return false;
  constexpr double kStands = 1e-9;  // mm and deg
  return std::all_of(kAllAxes.begin(), kAllAxes.end(), [&](Axis axis) {
    return !motion.known_after.contains(axis) || std::abs(motion.to[axis] - motion.from[axis]) <= kStands;
  });
}

inline AxisWords between(const AxisWords& from, const AxisWords& to, double fraction) {
  AxisWords words;
  for (const Axis axis : kAllAxes) words[axis] = from[axis] + fraction * (to[axis] - from[axis]);
  return words;
}

}  // namespace plumbline::path
