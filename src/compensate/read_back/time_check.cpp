#include "compensate/read_back/time_check.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "compensate/read_back/difference.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kTimeSlack = 6e-6;  // share of a block's time: F has six digits
constexpr double kNoLength = 1e-9;   // mm and deg
constexpr double kNoTime = 1e-9;     // s

double way(const AxisWords& d) {
  double sum = 0;
  for (const double value : d.values) sum += std::abs(value);
  return sum;
}

// Of a hole that is shifted the F stays, while both ends of its way are rounded: the share of its length that may make.
double share_of_rounding(const IntendedMove& meant, double linear_mm) {
  if (meant.form != IntendedMove::Form::kept || !meant.corrected || linear_mm <= kNoLength) return 0;
  return 2 * length_mm(meant.tolerance) / linear_mm;
}

}  // namespace

void TimeCheck::spend(const IntendedMove& meant, const nc::Motion& motion) {
  if (!path::is_cut(motion.kind)) return;
  const path::Curve curve(motion);
  length_ += way(curve.delta()) + curve.linear_mm();
  linear_mm_ += curve.linear_mm();
  if (!meant.seconds) return;
  const bool turns = meant.motion.feed_mode == nc::FeedMode::per_revolution;
  if (turns != (motion.feed_mode == nc::FeedMode::per_revolution)) throw Difference{"its feed is in another unit"};
  // Where nobody knows how F counts turns, a block that has none was given so few that it makes no difference.
  nc::Motion timed = motion;
  if (timed.feed_rule == nc::FeedRule::unknown) timed.feed_rule = nc::FeedRule::xyz_first;
  spent_ += path::duration(timed, curve, dialect_).value_or(0);
}

// A move whose end is where it begins, as far as the control can tell, takes no time.
void TimeCheck::end_move(const IntendedMove& meant, const SourceLine& at, ReadBackFigures& figures) const {
  if (!meant.seconds || *meant.seconds <= kNoTime) return;
  const bool clock = meant.motion.feed_mode != nc::FeedMode::per_revolution;
  if (meant.counts && clock) figures.seconds += spent_;
  if (length_ <= kNoLength) return;
  // It goes through as it stands, from where the correction left the axes.
  if (meant.motion.in_machine_coordinates) return;
  const double change = std::abs(spent_ / *meant.seconds - 1);
  if (change > tolerance_ + kTimeSlack + share_of_rounding(meant, linear_mm_)) {
    throw Difference{fmt::format("it takes {} {}, and {} were meant", to_decimal(spent_, 6),
                                 clock ? "s" : "revolutions", to_decimal(*meant.seconds, 6))};
  }
  const double of_original = spent_ / *meant.seconds * meant.time_share;
  if (meant.counts && clock) figures.time_change.take(std::abs(of_original - 1), at);
}

}  // namespace plumbline::compensate
