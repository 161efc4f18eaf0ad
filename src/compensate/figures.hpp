// Figures of positions that several files of this module look at.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/axes.hpp"
#include "nc/motion.hpp"

namespace plumbline::compensate {

inline double length_mm(const AxisWords& d) {
  return std::sqrt(d[Axis::X] * d[Axis::X] + d[Axis::Y] * d[Axis::Y] + d[Axis::Z] * d[Axis::Z]);
}

inline double largest_turn_deg(const AxisWords& d) {
  return std::max({std::abs(d[Axis::A]), std::abs(d[Axis::B]), std::abs(d[Axis::C])});
}

/// "X, Y"
inline std::string axis_list(AxisSet axes) {
  std::string list;
  for (const Axis axis : kAllAxes) {
    if (axes.contains(axis)) list += fmt::format("{}{}", list.empty() ? "" : ", ", letter(axis));
  }
  return list;
}

/// Under G95 the speed is the spindle's to say.
inline std::optional<double> clock_seconds(const nc::Motion& motion, std::optional<double> duration) {
  return motion.feed_mode == nc::FeedMode::per_revolution ? std::nullopt : duration;
}

}  // namespace plumbline::compensate
