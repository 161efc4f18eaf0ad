// What a canned cycle does at one hole.
#include "nc/control/families/hole_motions.hpp"

#include <algorithm>
#include <cmath>

#include "nc/control/families/cycle_codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kWrittenDigits = 1e10;  // decimals that a length may have been written with
constexpr double kNoise = 1e-13;         // and the rounding of a conversion
constexpr double kNoPeck = 1e-9;         // such controls count increments, in whole numbers

}  // namespace

void HoleMotions::go(MotionKind kind, double first, double second, double level) {
  Motion motion;
  motion.kind = kind;
  motion.to = control_.position;
  motion.to[axes_.first] = first;
  motion.to[axes_.second] = second;
  motion.to[axes_.third] = level;
  motion.known_after = control_.known;
  if (kind == MotionKind::feed) motion.feed = feed_ > 0 ? feed_ : feed_of_move(run_, true);
  add_motion(run_, motion);
}

void HoleMotions::wait() {
  const bool taps = is_tap(code_);
  const bool of_osp = run_.dialect.behaviour.return_levels;  // it waits where P says so [P onCyclePoint]
  if (as_fanuc_ && (taps || of_osp) && cycle_.dwell_s <= 0) return;
  Motion motion;
  motion.kind = MotionKind::dwell;
  motion.to = control_.position;
  motion.known_after = control_.known;
  motion.dwell_s = cycle_.dwell_s;
  add_motion(run_, motion);
}

void HoleMotions::at_hole() {
  feed_ = 0;
  if (code_ == kChipBreaking || code_ == kPeck) return pecks();
  if (code_ == kBackBore) return back_bore();
  const bool taps = is_tap(code_);
  if (taps && !as_fanuc_ && control_.modal.plane != Plane::xy) {
    along_tap(hole_.bottom);
    wait();
    along_tap(hole_.clear);
    control_.position[axes_.first] = hole_.first;
    control_.position[axes_.second] = hole_.second;
    control_.position[axes_.third] = hole_.clear;
    return;
  }
  along(MotionKind::feed, hole_.bottom);
  const bool waits = code_ != kDrill && code_ != kBore;
  if (waits || waits_as_osp()) wait();
  feed_ = cycle_.feed_out;
  if (code_ == kBore) along(MotionKind::feed, hole_.r);
  if (code_ == kBoreByHand) {
    control_.position[axes_.third] = hole_.clear;  // the operator takes it there
    return;
  }
  const bool feeds_out = taps || code_ == kBoreDwell;
  if (as_fanuc_ && feeds_out) along(MotionKind::feed, hole_.r);
  if (as_fanuc_ && feeds_out && hole_.clear == hole_.r) return;
  along(feeds_out && !as_fanuc_ ? MotionKind::feed : MotionKind::rapid, hole_.clear);
}

// A length in the program's unit, as the control counts pecks: in mm the last of them could fall short of the bottom by
// a rounding, and one more be made.
double HoleMotions::in_unit(double mm) const {
  const double value = mm / unit_;
  const double written = std::round(value * kWrittenDigits) / kWrittenDigits;
  return std::abs(value - written) < kNoise ? written : value;
}

void HoleMotions::pecks() {
  const bool increments = control_.modal.incremental;
  const double step = in_unit(cycle_.peck);
  const double r = in_unit(cycle_.r) + (increments ? in_unit(levels_.start) : 0);
  const double bottom = in_unit(cycle_.bottom) + (increments ? r : 0);
  const double together = in_unit(cycle_.peck_to_r) - kNoise;
  double up_at = r - together;
  const double last = as_fanuc_ ? bottom + kNoPeck : bottom;
  for (double at = r - step; at > last; at -= step) {
    const double depth = at * unit_;
    along(MotionKind::feed, depth);
    const bool far = cycle_.peck_to_r > 0 && at <= up_at;
    if (far) up_at = at - together;
    const bool breaks_chips = code_ == kChipBreaking || cycle_.peck_to_r > 0;
    if (!breaks_chips || far) along(MotionKind::rapid, hole_.r);
    const double gap = depth + run_.dialect.behaviour.peck_gap_mm;
    along(MotionKind::rapid, as_fanuc_ ? std::min(gap, hole_.r) : gap);  // pecks may be smaller than the gap set
  }
  along(MotionKind::feed, hole_.bottom);
  if (waits_as_osp()) wait();
  along(MotionKind::rapid, hole_.clear);
}

// The axes of the plane, one place on.
void HoleMotions::along_tap(double level) {
  Motion motion;
  motion.kind = MotionKind::feed;
  motion.to = control_.position;
  const bool zx = control_.modal.plane == Plane::zx;
  motion.to[axes_.first] = zx ? hole_.second : level;
  motion.to[axes_.second] = zx ? level : hole_.first;
  motion.to[axes_.third] = zx ? hole_.first : hole_.second;
  motion.known_after = control_.known;
  motion.feed = feed_of_move(run_, true);
  add_motion(run_, motion);
}

// Down beside the hole, up into it from below.
void HoleMotions::back_bore() {
  const double first = hole_.first + cycle_.ijk[index(axes_.first)];
  const double second = hole_.second + cycle_.ijk[index(axes_.second)];
  go(MotionKind::rapid, first, second, hole_.r);
  go(MotionKind::rapid, first, second, hole_.bottom);
  along(MotionKind::rapid, hole_.bottom);
  along(MotionKind::feed, levels_.offset);
  along(MotionKind::feed, hole_.bottom);
  go(MotionKind::rapid, first, second, hole_.bottom);
  go(MotionKind::rapid, first, second, hole_.clear);
  along(MotionKind::rapid, hole_.clear);
}

}  // namespace plumbline::nc
