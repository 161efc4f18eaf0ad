// What another interpreter makes of a program: its canonical calls as text, read into motions.
#pragma once

#include <string>
#include <vector>

#include "nc/control/state/motion.hpp"

namespace plumbline::nc::tests {

/// A move and the length in mm of the unit that its numbers are written in.
struct CanonMotion {
  Motion motion;
  double unit_mm = 1;
  bool spline = false;         // no more is said of it than that it is one
  double offsets_unit_mm = 1;  // the longest unit that offsets were written in so far
};

/// STRAIGHT_TRAVERSE, STRAIGHT_FEED, STRAIGHT_PROBE, ARC_FEED, RIGID_TAP (down and back), NURBS_FEED and DWELL; feeds
/// of SET_FEED_RATE; the display of the machine from the offsets, rotation and tool length in force. A dwell has no
/// positions.
std::vector<CanonMotion> read_canon(const std::string& path);

/// The first difference between the motions of a program and the canonical ones, with both; "" if they agree to
/// `tolerance` of the unit. Feeds are compared under G94 where X, Y or Z move.
std::string first_difference(const std::vector<Motion>& ours, const std::vector<CanonMotion>& theirs, double tolerance);

}  // namespace plumbline::nc::tests
