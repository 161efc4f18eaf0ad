#include "path/duration.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "nc/rewrite/feed.hpp"

namespace plumbline::path {

std::optional<double> duration(const nc::Motion& motion, const Curve& curve, const nc::Dialect& dialect) {
  const bool cuts = motion.kind == nc::MotionKind::feed || motion.kind == nc::MotionKind::arc;
  if (!cuts || motion.unknown_strokes || motion.feed <= 0) return std::nullopt;
  std::optional<double> length =
      nc::feed_length(curve.linear_mm(), curve.delta(), motion.feed_rule, motion.mm_per_unit);
  if (motion.feed_along_circle && motion.kind == nc::MotionKind::arc) length = curve.circle_mm();
  if (motion.feed_mode == nc::FeedMode::inverse_time) {
    // F is the feed over the radius: an arc of the angle a takes a / F [B-62764EN 5].
    if (dialect.behaviour.inverse_time_by_radius && motion.kind == nc::MotionKind::arc)
      return std::abs(curve.arc_deg()) * kDeg / motion.feed * kMinute;
    if (!length) return kMinute / motion.feed;
    if (*length <= 0) return 0;  // LinuxCNC leaves such a move out [measured]
    // RS274/NGC: the rate is length x F, and never less than the control's least.
    const bool in_degrees = nc::feed_length_is_angle(curve.linear_mm());
    const double least = dialect.feed_rate_min * (in_degrees ? 1 : motion.mm_per_unit);
    const double rate = std::max(*length * motion.feed, least);
    return *length / rate * kMinute;
  }
  if (!length) return std::nullopt;
  const double per_feed = *length / motion.feed;
  return motion.feed_mode == nc::FeedMode::per_minute ? per_feed * kMinute : per_feed;
}

}  // namespace plumbline::path
