#include "nc/rewrite/piece_feeds.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/rewrite/feed.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {
namespace {

constexpr double kAlikeSpeeds = 0.02;  // pieces of a block whose speeds differ less share one F
constexpr double kHasty = 2;           // times the speed of its block: a piece as fast shares the F of the others
constexpr double kSameFeed = 1e-12;    // relative
constexpr double kNearFeed = 1e-4;     // as near as F must be written at least,
constexpr double kOfTolerance = 0.9;   // of that of the time, where the control has F no finer,
constexpr double kSixDigits = 5e-6;    // as near as six digits are
constexpr int kMoreOfTurn = 2;         // decimals of a feed a turn, which is hundreds of times smaller
constexpr double kLeastFeed = 1e-6;
constexpr double kLargestFeed = 1e12;

bool turns(const Motion& motion) {
  return std::any_of(kAllAxes.begin(), kAllAxes.end(),
                     [&](Axis axis) { return is_rotary(axis) && motion.to[axis] != motion.from[axis]; });
}

[[noreturn]] void refuse_feed_rule(const Step& step, const Dialect& dialect, const EmitSettings& settings) {
  const Motion& motion = step.motions.front();
  // by a bound each piece is proven with its A, B and C, which cannot wait then
  const std::string_view by_steps =
      settings.keep_piece_times && !turns(motion) ? "; or take fixed steps in place of --tolerance" : "";
  const std::string what = !turns(motion)
                               ? "nothing turns in this block, but its correction does, as much as it moves: "
                           : length_mm(motion.to - motion.from) > 0 ? "this block moves and turns: "
                                                                    : "this block turns, and its correction moves: ";
  refuse_block(*step.block, "emit-feed-rule",
               fmt::format("{}dialect {} does not say which speed F is then", what, dialect.name),
               "say how the control counts: --feed-rule xyz (F is the speed along X, Y, Z) or --feed-rule all (degrees "
               "count as mm); or program the block in inverse time (G93)" +
                   std::string(by_steps));
}

[[noreturn]] void refuse_turn_alone(const Step& step) {
  const bool group = step.motions.front().feed_rule == FeedRule::path_group;
  refuse_block(
      *step.block, "emit-feed-rule",
      fmt::format("F is the speed of {} here, and A, B, C turn where {}: how long that takes no program says, and "
                  "beside the micrometres of the correction F would mean another time",
                  group ? "the axes of the path group (X, Y, Z)" : "the tool's tip",
                  group ? "none of them moves" : "the tip stands still"),
      group ? "write FGROUP() before the block, or program it in inverse time (G93)"
            : "program the block in inverse time (G93), or say which speed F is on this control: --feed-rule xyz or "
              "all");
}

// The move goes less far in X, Y and Z than a word says, or a piece of it that was proven as it is does.
[[noreturn]] void refuse_short_way(const Step& step, bool is_piece) {
  const bool group = step.motions.front().feed_rule == FeedRule::path_group;
  refuse_block(
      *step.block, "emit-feed-rule",
      fmt::format("corrected, {} turns A, B, C and moves X, Y, Z by less than the control keeps of a word, and "
                  "F is the speed of {}: no F says how long it takes",
                  is_piece ? "a piece of this block" : "this block",
                  group ? "the axes of the path group (X, Y, Z)" : "the tool's tip"),
      is_piece ? "take fixed steps in place of --tolerance; or program the block in inverse time (G93)"
      : group  ? "let it be one with the block before or after it; or write FGROUP() before it, or program it "
                 "in inverse time (G93)"
               : "let it be one with the block before or after it; or program it in inverse time (G93)");
}

bool tip_stands(const Motion& motion) {
  const AxisWords delta = motion.to - motion.from;
  return counts_linear_axes(motion.feed_rule) && motion.feed_mode != FeedMode::inverse_time && motion.feed > 0 &&
         motion.kind == MotionKind::feed && length_mm(delta) == 0 &&
         std::abs(delta[Axis::A]) + std::abs(delta[Axis::B]) + std::abs(delta[Axis::C]) > kSamePlace;
}

}  // namespace

void PieceFeeds::refuse_feed(double feed) const {
  const bool inverse_time = step_.after->feed_mode == FeedMode::inverse_time;
  refuse_block(*step_.block, "emit-feed-range", fmt::format("this block would need F{:.6g} to keep its time", feed),
               inverse_time ? "check its feed, or let several such blocks be one"
                            : "check its feed, let several such blocks be one, or program the block in inverse time "
                              "(G93)");
}

// F as written: six digits that count, so that it is within 5e-6 of what was asked; fewer where the control takes no
// longer words.
double PieceFeeds::rounded_feed(double feed) const {
  if (!(feed > kLeastFeed && feed < kLargestFeed)) refuse_feed(feed);
  const int of_six = std::clamp(5 - static_cast<int>(std::floor(std::log10(feed))), 0, kMostDecimals);
  const bool per_turn = step_.after->feed_mode == FeedMode::per_revolution;
  const int of_control = std::min(of_six, dialect_.behaviour.feed_decimals + (per_turn ? kMoreOfTurn : 0));
  const int decimals = decimals_within(dialect_.behaviour.most_digits, feed, of_control);
  const double rounded = from_ticks(to_ticks(feed, decimals), decimals);
  const double own = settings_.time_tolerance * (in_the_middle_ ? kOfTolerance / 2 : kOfTolerance);
  const double near = std::min(kNearFeed, settings_.time_tolerance / 2 + kSixDigits);
  if (differs(rounded, feed, of_control < of_six ? own : near)) refuse_feed(feed);
  return rounded;
}

double PieceFeeds::choose(const AxisWords& start, double seconds, OutputState& control) {
  set_lengths(start);
  control.change_unit(*step_.before, *step_.after);
  return step_.after->feed_mode == FeedMode::inverse_time ? choose_inverse_times(seconds, control)
                                                          : choose_rates(seconds, control);
}

void PieceFeeds::keep(bool has_time, OutputState& control) const {
  const Motion& motion = step_.motions.front();
  if (tip_stands(motion)) refuse_turn_alone(step_);
  const bool cuts = motion.kind == MotionKind::feed || motion.kind == MotionKind::arc;
  const AxisWords travel = motion.to - motion.from;
  if (cuts && !has_time && motion.feed > 0 &&
      !feed_length(length_mm(travel), travel, motion.feed_rule, motion.mm_per_unit))
    refuse_feed_rule(step_, dialect_, settings_);
  control.change_unit(*step_.before, *step_.after);
  if (find_word(*step_.block, 'F') == nullptr) return;
  control.feed = step_.after->feed;
  control.feed_rotary = step_.after->feed_rotary;
}

void PieceFeeds::set_lengths(const AxisWords& start) {
  AxisWords at = start;
  const Motion& motion = step_.motions.front();
  const auto turns_little = [&](double share) {
    return motion.feed_rule == FeedRule::unknown && !turns(motion) &&
           turns_count_little(start, ends_, motion.mm_per_unit, share);
  };
  const bool little = turns_little(settings_.time_tolerance);
  in_the_middle_ = little && !turns_little(settings_.time_tolerance / 2);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const AxisWords delta = ends_[i] - at;
    const std::optional<ArcShape> arc =
        pieces_[i].arc ? std::optional(arc_shape(at, ends_[i], pieces_[i].arc->arc)) : std::nullopt;
    const double linear = arc ? arc->length_mm() : length_mm(delta);
    const FeedRule rule = little ? FeedRule::xyz_first : motion.feed_rule;
    std::optional<double> length = feed_length(linear, delta, rule, motion.mm_per_unit);
    if (arc && motion.feed_along_circle) length = arc->circle_mm();
    // As far off under the one rule as under the other, and half as far as they are apart.
    if (in_the_middle_ && linear > 0)
      length = (linear + *feed_length(linear, delta, FeedRule::all_axes_as_mm, motion.mm_per_unit)) / 2;
    if (!length && counts_linear_axes(motion.feed_rule) && motion.feed_mode != FeedMode::inverse_time) {
      if (tip_stands(motion)) refuse_turn_alone(step_);
      refuse_short_way(step_, pieces_.size() > 1);
    }
    // The time is F alone under G93, unless the control lifts the speed to its least rate.
    const bool needless = motion.feed_mode == FeedMode::inverse_time && dialect_.feed_rate_min <= 0;
    if (!length && !counts_linear_axes(motion.feed_rule) && !needless) refuse_feed_rule(step_, dialect_, settings_);
    // A feed a revolution counts degrees as it counts millimetres, and follows the unit.
    const bool turns_alone = feed_length_is_angle(linear);
    pieces_[i].in_degrees = turns_alone && motion.feed_mode != FeedMode::per_revolution;
    pieces_[i].length = length.value_or(turns_alone ? 0 : linear) / (pieces_[i].in_degrees ? 1 : motion.mm_per_unit);
    at = ends_[i];
  }
}

// Degrees a minute do not follow a change of units; lengths a minute do.
double PieceFeeds::in_force(const Piece& piece, const OutputState& control) {
  return piece.in_degrees ? control.feed_rotary : control.feed;
}

// Where the control reads F before the units of its own block, it counts in those that were in force before it.
void PieceFeeds::state_feed(Piece& piece, double feed, OutputState& control) const {
  const bool of_block = &piece == &pieces_.front() && dialect_.feed_before_units;
  const bool changes = of_block && step_.before->inches != step_.after->inches;
  const double ratio = !changes ? 1 : step_.after->inches ? kMmPerInch : 1 / kMmPerInch;
  const double written = piece.in_degrees ? feed : feed * ratio;
  const Word* const word = find_word(*step_.block, 'F');
  const bool as_written = word != nullptr && !differs(word->value, written, kSameFeed);
  piece.feed = as_written ? word->value : changes ? rounded_feed(written) : feed;
  control.feed = *piece.feed / ratio;
  control.feed_rotary = *piece.feed;
}

// How far the lengths of pieces of one speed may be apart where their ends are rounded, in the program's unit: on a
// grid of 1 um, those of 0.9 um are 0, 1 and 1.4 um long. Of a move that turns they say how fast it turns.
double PieceFeeds::lost_to_rounding() const {
  if (settings_.keep_piece_times || turns(step_.motions.front())) return 0;
  const bool inches = step_.after->inches;
  const Kept kept = kept_of_axis_word(dialect_.behaviour, false, inches, settings_.increment_ratio, false);
  const int digits = std::min(inches ? settings_.digits_inch : settings_.digits_mm, kept.decimals);
  const double increment = std::max(settings_.increment_mm / (inches ? kMmPerInch : 1), kept.quantum);
  constexpr double kEnds = 2;  // each half a step off, in up to three axes
  return kEnds * std::max(from_ticks(1, std::max(digits, 0)), increment);
}

// The F of each piece under G94 and G95: the program's where that keeps the time of the block; one other F for all
// pieces where their speeds are alike; else each its own, as where a turn gains micrometres of X, Y, Z.
double PieceFeeds::choose_rates(double seconds, OutputState& control) {
  const double unit = step_.after->feed_mode == FeedMode::per_minute ? kMinute : 1;
  const double time = seconds / unit;
  double total = 0;
  for (const Piece& piece : pieces_) total += piece.length;
  const bool turns = std::all_of(pieces_.begin(), pieces_.end(), [](const Piece& piece) { return piece.in_degrees; });
  const double programmed = turns ? step_.after->feed_rotary : step_.after->feed;
  const bool alike = std::all_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    return !differs(piece.length, piece.share * total, kAlikeSpeeds);
  });
  const double rounding = lost_to_rounding();
  // At a corner friction turns, and the first micrometre of an arc has the whole jump of its correction to make.
  const auto is_even = [&](const Piece& piece) {
    const double even = piece.share * total;
    const bool is_hasty = rounding > 0 && piece.length > kHasty * even;
    return alike || (!piece.in_degrees && (is_hasty || std::abs(piece.length - even) <= rounding));
  };
  double even_length = 0;
  double even_share = 0;
  for (const Piece& piece : pieces_) {
    if (!is_even(piece)) continue;
    even_length += piece.length;
    even_share += piece.share;
  }
  const double kept = settings_.time_tolerance * (in_the_middle_ ? 0.5 : 1);  // the rules take the other half
  const bool keeps = !differs(total / programmed, time, kept) && (alike || !settings_.keep_piece_times);
  pieces_.front().restates_mode = control.feed_mode != step_.after->feed_mode;
  if (pieces_.front().restates_mode) control.drop_feed();
  control.feed_mode = step_.after->feed_mode;
  double spent = 0;
  for (Piece& piece : pieces_) {
    double feed = programmed;
    if (!keeps && piece.length > 0) {
      const bool even = is_even(piece) && even_length > 0;
      feed = rounded_feed(even ? even_length / (even_share * time) : piece.length / (piece.share * time));
    }
    const bool stated = &piece == &pieces_.front() && find_word(*step_.block, 'F') != nullptr;
    const double allowed = keeps ? 0 : settings_.time_tolerance / 4;
    const double standing = in_force(piece, control);
    if (stated || standing <= 0 || differs(feed, standing, allowed)) state_feed(piece, feed, control);
    spent += piece.length / in_force(piece, control);
  }
  return spent * unit;
}

// F under G93, as the control keeps it.
double PieceFeeds::inverse_time(double per_minute) const {
  const double least = dialect_.behaviour.inverse_time_increment;
  if (least <= 0) return rounded_feed(per_minute);
  const double largest = largest_inverse_feed(dialect_.behaviour);
  const double kept = std::round(per_minute / least) * least;
  if (kept <= largest && std::abs(kept - per_minute) <= settings_.time_tolerance * 10 * per_minute) return kept;
  if (const double own = step_.motions.front().feed; own > largest) {
    refuse_block(*step_.block, "emit-feed-range",
                 fmt::format("this block has F{:.6g}, and F under G93 goes from {} to {}", own, to_decimal(least),
                             to_decimal(largest, 3)),
                 "the control does not take this F: under G93 it is one over the time of the block in minutes, so look "
                 "whether G94 was meant");
  }
  refuse_block(
      *step_.block, "emit-feed-range",
      fmt::format("a piece of this block would need F{:.6g}, and F under G93 goes from {} to {} in steps of {}",
                  per_minute, to_decimal(least), to_decimal(largest, 3), to_decimal(least)),
      kept > largest
          ? "let several such blocks be one, or let pieces be longer: block_time_ms in [control] of the model"
          : "let pieces be shorter: --step-length, --step-angle");
}

// G93: each piece its share of the time; where the control would lift length x F to its least rate, that piece goes
// under G94 with the rate itself.
double PieceFeeds::choose_inverse_times(double seconds, OutputState& control) {
  double spent = 0;
  for (Piece& piece : pieces_) {
    const double minutes = piece.share * seconds / kMinute;
    const double rate = piece.length / minutes;
    piece.leaves_inverse_time = rate < dialect_.feed_rate_min && piece.length > 0;
    const FeedMode mode = piece.leaves_inverse_time ? FeedMode::per_minute : FeedMode::inverse_time;
    piece.restates_mode = mode != control.feed_mode;
    control.feed_mode = mode;
    const bool whole = pieces_.size() == 1 && !piece.leaves_inverse_time;
    const double feed = piece.leaves_inverse_time ? rounded_feed(rate) : inverse_time(1 / minutes);
    const bool keep = whole && !differs(step_.motions.front().feed, feed, settings_.time_tolerance);
    if (!keep && piece.leaves_inverse_time) state_feed(piece, feed, control);
    if (!keep && !piece.leaves_inverse_time) piece.feed = feed;
    spent += piece.leaves_inverse_time ? piece.length / feed : 1 / (keep ? step_.motions.front().feed : feed);
  }
  control.drop_feed();
  return spent * kMinute;
}

}  // namespace plumbline::nc
