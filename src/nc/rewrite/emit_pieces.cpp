#include "nc/rewrite/emit_pieces.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/control/kept.hpp"
#include "nc/rewrite/emit_text.hpp"
#include "nc/rewrite/feed.hpp"

namespace plumbline::nc {
namespace {

constexpr double kAlikeSpeeds = 0.02;  // pieces of a block whose speeds differ less share one F
constexpr double kLargestWord = 1e6;   // with nine decimals this still is exact in a double
constexpr double kArcStart = 1e-7;     // mm
constexpr double kSamePlace = 1e-9;    // mm and deg
constexpr double kSameFeed = 1e-12;    // relative
constexpr double kLeastFeed = 1e-6;
constexpr double kLargestFeed = 1e12;
constexpr double kMoves = 0.25;  // of a quantum: less than this is the noise of adding and taking away offsets

double distance_mm(const AxisWords& a, const AxisWords& b) {
  const AxisWords d = a - b;
  return std::sqrt(d[Axis::X] * d[Axis::X] + d[Axis::Y] * d[Axis::Y] + d[Axis::Z] * d[Axis::Z]);
}

bool turns(const Motion& motion) {
  return std::any_of(kAllAxes.begin(), kAllAxes.end(),
                     [&](Axis axis) { return is_rotary(axis) && motion.to[axis] != motion.from[axis]; });
}

[[noreturn]] void refuse_feed_rule(const Step& step, const Dialect& dialect) {
  const Motion& motion = step.motions.front();
  const std::string what = !turns(motion)
                               ? "nothing turns in this block, but its correction does, as much as it moves: "
                           : distance_mm(motion.to, motion.from) > 0 ? "this block moves and turns: "
                                                                     : "this block turns, and its correction moves: ";
  refuse_block(*step.block, "emit-feed-rule",
               fmt::format("{}dialect {} does not say which speed F is then", what, dialect.name),
               "say how the control counts: --feed-rule xyz (F is the speed along X, Y, Z) or --feed-rule all (degrees "
               "count as mm); or program the block in inverse time (G93)");
}

[[noreturn]] void refuse_turn_alone(const Step& step) {
  refuse_block(
      *step.block, "emit-feed-rule",
      "F is the speed of the tool's tip here, and A, B, C turn where the tip stands still: how long that takes "
      "no program says, and beside the micrometres of the correction F would mean another time",
      "program the block in inverse time (G93), or say which speed F is on this control: --feed-rule xyz or "
      "all");
}

bool tip_stands(const Motion& motion) {
  const AxisWords delta = motion.to - motion.from;
  return motion.feed_rule == FeedRule::tool_tip && motion.feed_mode != FeedMode::inverse_time && motion.feed > 0 &&
         motion.kind == MotionKind::feed && distance_mm(delta, {}) == 0 &&
         std::abs(delta[Axis::A]) + std::abs(delta[Axis::B]) + std::abs(delta[Axis::C]) > kSamePlace;
}

// Numbers that cannot be written with all their digits.
void check_word(const Step& step, double value) {
  if (std::abs(value) < kLargestWord) return;
  refuse_block(*step.block, "emit-out-of-range", fmt::format("this block would need the number {:.6g}", value),
               "check the words and offsets of the block: no machine goes there");
}

// F as written: six digits that count, so that it is within 5e-6 of what was asked.
double rounded_feed(const Step& step, double feed) {
  if (!(feed > kLeastFeed && feed < kLargestFeed)) {
    refuse_block(*step.block, "emit-feed-range", fmt::format("this block would need F{:.6g} to keep its time", feed),
                 "check its feed, or let several such blocks be one");
  }
  const int decimals = std::clamp(5 - static_cast<int>(std::floor(std::log10(feed))), 0, kMostDecimals);
  return from_ticks(to_ticks(feed, decimals), decimals);
}

bool differs(double a, double b, double tolerance) { return std::abs(a - b) > tolerance * std::abs(b); }

}  // namespace

PiecePlanner::Grid PiecePlanner::grid(const Step& step, Axis axis) const {
  const Word* word = find_word(*step.block, letter(axis));
  const int written = word != nullptr ? word->decimals : 0;
  const bool inches = step.after->inches && !is_rotary(axis);
  const double per_unit = inches ? kMmPerInch : 1.0;
  const int least = is_rotary(axis) ? settings_.digits_deg : (inches ? settings_.digits_inch : settings_.digits_mm);
  const ControlBehaviour& behaviour = dialect_.behaviour;
  const Kept kept =
      kept_of_axis_word(behaviour, is_rotary(axis), inches, settings_.increment_ratio, step.after->incremental);
  const double increment = (is_rotary(axis) ? settings_.increment_deg : settings_.increment_mm) / per_unit;
  return {written_number(kept, std::max(least, written), increment), per_unit};
}

bool PiecePlanner::stays(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                         const OutputState& control) const {
  const AxisWords standing = control.work_shift(*step.frame);
  const Motion& motion = step.motions.front();
  const bool arc = motion.kind == MotionKind::arc;
  for (const Axis axis : kAllAxes) {
    if (!writable.contains(axis)) continue;
    const Grid g = grid(step, axis);
    const double half = g.quantum * g.per_unit / 2;
    // An arc may be none at all where its start is a little off its end, and an axis turn all the way round.
    const double allowed = counts_turns(step, axis) ? kSamePlace : arc ? std::min(half, kArcStart) : half;
    if (depends_on_start(step, axis) && motion.known_before.contains(axis) && std::abs(standing[axis]) >= allowed)
      return false;
    for (const CorrectedPoint& point : points) {
      if (std::abs(point.shift[axis]) >= half) return false;
    }
  }
  return keeps_time(step, standing);
}

// A cut whose start was rounded to another place is longer or shorter: one of some micrometres needs another F.
bool PiecePlanner::keeps_time(const Step& step, const AxisWords& standing) const {
  const Motion& motion = step.motions.front();
  if (motion.kind != MotionKind::feed || motion.feed_mode == FeedMode::inverse_time) return true;
  AxisWords off;
  for (const Axis axis : kAllAxes) {
    if (motion.known_before.contains(axis) && !depends_on_start(step, axis)) off[axis] = standing[axis];
  }
  const AxisWords way = motion.to - motion.from;
  const auto length = [&](const AxisWords& d) {
    return feed_length(distance_mm(d, {}), d, motion.feed_rule, motion.mm_per_unit).value_or(0);
  };
  const double before = length(way);
  return before <= kSamePlace || !differs(length(way - off), before, settings_.time_tolerance);
}

// Its absolute words are counted from where it stands.
bool PiecePlanner::counts_turns(const Step& step, Axis axis) {
  return step.named.contains(axis) && !step.after->incremental && step.after->rule_of(axis) != RotaryRule::linear;
}

bool PiecePlanner::depends_on_start(const Step& step, Axis axis) {
  const bool all = step.after->incremental || step.polar || step.motions.front().kind == MotionKind::arc;
  if (all || !step.named.contains(axis) || counts_turns(step, axis)) return true;
  const Word* const word = find_word(*step.block, letter(axis));
  return word != nullptr && word->mode == WordMode::incremental;
}

// The word that sends an axis which turns without end to `to`. Where it stands may not be known: then the way round is
// the one that the original goes.
double PiecePlanner::endless_word(const Step& step, Axis axis, double to, std::optional<double> from) const {
  const bool direct = dialect_.syntax.word_modes;
  const RotaryRule rule = direct ? RotaryRule::shortest : step.after->rule_of(axis);
  std::optional<double> word = within_one_turn(to);
  if (from) {
    word = rotary_word(rule, to, *from);
  } else if (rule != RotaryRule::shortest) {
    const Word* const written = find_word(*step.block, letter(axis));
    const double place = written != nullptr ? within_one_turn(std::abs(written->value)) : *word;
    if (std::abs(place - *word) > kFullTurn / 2) word.reset();
    if (word && written != nullptr && rule == RotaryRule::sign && std::signbit(written->value)) word = -*word;
  }
  const bool in_first_turn =
      from || !word || std::abs(rotary_end(rule, *word, std::signbit(*word), {}) - to) < kSamePlace;
  if (word && in_first_turn) return *word;
  refuse_block(*step.block, "emit-rotary-word",
               fmt::format("no word sends {} to {:.6g}, where the corrected move ends: its words count within a turn",
                           letter(axis), to),
               from ? "turn there in two blocks, or by increments (G91)"
                    : "say where the axis stands (--start), so that the way round is known");
}

bool PiecePlanner::rounds_to_zero(const Step& step, const AxisWords& shift, AxisSet writable) const {
  return std::all_of(kAllAxes.begin(), kAllAxes.end(), [&](Axis axis) {
    const Grid g = grid(step, axis);
    return !writable.contains(axis) || std::abs(shift[axis]) < g.quantum * g.per_unit / 2;
  });
}

double PiecePlanner::rounded(const Step& step, Axis axis, double value) const {
  check_word(step, value);
  return grid(step, axis).kept(value);
}

double PiecePlanner::offset_word(const Step& step, Axis axis, double value) const {
  if (dialect_.behaviour.keeps_increment) return rounded(step, axis, value);
  check_word(step, value);
  return value;
}

std::span<Piece> PiecePlanner::plan(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                                    std::optional<double> seconds, OutputState& control) {
  const Motion& motion = step.motions.front();
  for (const Axis axis : kAllAxes) grid_[index(axis)] = grid(step, axis);
  pieces_.clear();
  ends_.clear();
  rounding_mm_ = 0;
  seconds_.reset();
  const AxisWords start = motion.from + control.work_shift(*step.frame);
  AxisWords at = start;
  double waiting = 0;  // share of pieces in which nothing moved
  for (std::size_t i = 0; i < points.size(); ++i) {
    Piece piece = rounded_piece(step, points[i], writable, at);
    piece.share = points[i].share + waiting;
    waiting = 0;
    const bool only_one = i + 1 == points.size() && pieces_.empty();
    if (piece.moved.empty() && !only_one) {
      waiting = piece.share;
      continue;
    }
    pieces_.push_back(piece);
    ends_.push_back(at);
  }
  pieces_.back().share += waiting;
  AxisWords left;
  for (const Axis axis : kAllAxes) left[axis] = motion.known_after.contains(axis) ? at[axis] - motion.to[axis] : 0;
  if (seconds && *seconds > 0) {
    set_lengths(step, start);
    choose_feeds(step, *seconds, control);
  } else if (tip_stands(motion)) {
    refuse_turn_alone(step);
  } else {
    const bool cuts = motion.kind == MotionKind::feed || motion.kind == MotionKind::arc;
    const AxisWords way = motion.to - motion.from;
    if (cuts && !seconds && motion.feed > 0 &&
        !feed_length(distance_mm(way, {}), way, motion.feed_rule, motion.mm_per_unit))
      refuse_feed_rule(step, dialect_);
    control.change_unit(*step.before, *step.after);
    if (find_word(*step.block, 'F') != nullptr) {
      control.feed = step.after->feed;
      control.feed_rotary = step.after->feed_rotary;
    }
  }
  control.set_work_shift(*step.frame, left);
  return pieces_;
}

void PiecePlanner::check_digits(const Step& step, double value, int decimals) const {
  const int most = dialect_.behaviour.most_digits;
  if (most == 0 || std::abs(value) < std::pow(10, most - decimals)) return;
  refuse_block(
      *step.block, "emit-out-of-range",
      fmt::format("this block would need the number {:.3f}, and {} takes {} digits", value, dialect_.name, most),
      "check the words and offsets of the block: no machine goes there");
}

// Rounds one point, tells which axes move to it, and moves `at` there.
Piece PiecePlanner::rounded_piece(const Step& step, const CorrectedPoint& point, AxisSet writable, AxisWords& at) {
  Piece piece;
  const AxisWords target = point.nominal + point.shift;
  const bool first = pieces_.empty();
  piece.direct = dialect_.syntax.word_modes;
  for (const Axis axis : kAllAxes) {
    const std::size_t i = index(axis);
    const Grid& g = grid_[i];
    piece.digits[i] = g.digits;
    if (!writable.contains(axis)) {
      at[axis] = target[axis];
      continue;
    }
    const bool known = step.motions.front().known_before.contains(axis) || !first;
    const double wanted = (step.after->incremental ? target[axis] - at[axis] : target[axis]) / g.per_unit;
    check_word(step, wanted);
    const double value = g.kept(wanted);
    check_digits(step, value, g.digits);
    double end = step.after->incremental ? at[axis] + value * g.per_unit : value * g.per_unit;
    const bool endless = !step.after->incremental && step.after->rule_of(axis) != RotaryRule::linear;
    // Downwards to 0 would be -0, which is not the same to every control: the last step is left out.
    if (endless && known && end < at[axis] && within_one_turn(end) == 0) end += g.quantum;
    if (endless) piece.endless.insert(axis);
    piece.value[axis] = value;
    // A word that stands there is written as it is kept now, though the axis was left with more digits.
    const bool says = first && !endless && !step.after->incremental && step.named.contains(axis) && end != at[axis];
    if (!known || says || std::abs(end - at[axis]) > kMoves * g.quantum * g.per_unit) {
      if (endless) piece.value[axis] = endless_word(step, axis, end, known ? std::optional(at[axis]) : std::nullopt);
      piece.moved.insert(axis);
      at[axis] = end;
    } else if (step.after->incremental) {
      piece.value[axis] = 0;
    }
  }
  rounding_mm_ = std::max(rounding_mm_, distance_mm(at, target));
  return piece;
}

void PiecePlanner::set_lengths(const Step& step, const AxisWords& start) {
  AxisWords at = start;
  const Motion& motion = step.motions.front();
  const bool little = motion.feed_rule == FeedRule::unknown && !turns(motion) &&
                      turns_count_little(start, ends_, motion.mm_per_unit, settings_.time_tolerance / 2);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const AxisWords delta = ends_[i] - at;
    const double linear = distance_mm(delta, {});
    const FeedRule rule = little ? FeedRule::xyz_first : motion.feed_rule;
    const std::optional<double> length = feed_length(linear, delta, rule, motion.mm_per_unit);
    if (!length && motion.feed_rule == FeedRule::tool_tip && motion.feed_mode != FeedMode::inverse_time)
      refuse_turn_alone(step);
    if (!length && motion.feed_rule != FeedRule::tool_tip) refuse_feed_rule(step, dialect_);
    pieces_[i].in_degrees = feed_length_is_angle(linear);
    pieces_[i].length = pieces_[i].in_degrees ? length.value_or(0) : *length / motion.mm_per_unit;
    at = ends_[i];
  }
}

void PiecePlanner::choose_feeds(const Step& step, double seconds, OutputState& control) {
  control.change_unit(*step.before, *step.after);
  if (step.after->feed_mode == FeedMode::inverse_time) {
    choose_inverse_times(step, seconds, control);
  } else {
    choose_rates(step, seconds, control);
  }
}

// Degrees a minute do not follow a change of units; lengths a minute do.
double PiecePlanner::feed_in_force(const Piece& piece, const OutputState& control) const {
  return piece.in_degrees ? control.feed_rotary : control.feed;
}

// Where the control reads F before the units of its own block, it counts in those that were in force before it.
void PiecePlanner::state_feed(const Step& step, Piece& piece, double feed, OutputState& control) const {
  const bool of_block = &piece == &pieces_.front() && dialect_.feed_before_units;
  const bool changes = of_block && step.before->inches != step.after->inches;
  const double ratio = !changes ? 1 : step.after->inches ? kMmPerInch : 1 / kMmPerInch;
  const double written = piece.in_degrees ? feed : feed * ratio;
  const Word* const word = find_word(*step.block, 'F');
  const bool as_written = word != nullptr && !differs(word->value, written, kSameFeed);
  piece.feed = as_written ? word->value : changes ? rounded_feed(step, written) : feed;
  control.feed = *piece.feed / ratio;
  control.feed_rotary = *piece.feed;
}

// The F of each piece under G94 and G95: the program's where that keeps the time of the block; one other F for all
// pieces where their speeds are alike; else each its own, as where a turn gains micrometres of X, Y, Z.
void PiecePlanner::choose_rates(const Step& step, double seconds, OutputState& control) {
  const double unit = step.after->feed_mode == FeedMode::per_minute ? kMinute : 1;
  const double time = seconds / unit;
  double total = 0;
  for (const Piece& piece : pieces_) total += piece.length;
  const bool turns = std::all_of(pieces_.begin(), pieces_.end(), [](const Piece& piece) { return piece.in_degrees; });
  const double programmed = turns ? step.after->feed_rotary : step.after->feed;
  const bool keeps = !differs(total / programmed, time, settings_.time_tolerance);
  const double mean = total / time;
  const bool alike = std::all_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    return !differs(piece.length, piece.share * total, kAlikeSpeeds);
  });
  pieces_.front().restates_mode = control.feed_mode != step.after->feed_mode;
  if (pieces_.front().restates_mode) control.drop_feed();
  control.feed_mode = step.after->feed_mode;
  double spent = 0;
  for (Piece& piece : pieces_) {
    double feed = programmed;
    if (!keeps && piece.length > 0) feed = rounded_feed(step, alike ? mean : piece.length / (piece.share * time));
    const bool stated = &piece == &pieces_.front() && find_word(*step.block, 'F') != nullptr;
    const double allowed = keeps ? 0 : settings_.time_tolerance / 4;
    const double in_force = feed_in_force(piece, control);
    if (stated || in_force <= 0 || differs(feed, in_force, allowed)) state_feed(step, piece, feed, control);
    spent += piece.length / feed_in_force(piece, control);
  }
  seconds_ = spent * unit;
}

// F under G93, as the control keeps it.
double PiecePlanner::inverse_time(const Step& step, double per_minute) const {
  const double least = dialect_.behaviour.inverse_time_increment;
  if (least <= 0) return rounded_feed(step, per_minute);
  const double largest = std::pow(10, dialect_.behaviour.most_digits - 1) * least - least;  // 9999.999 of 0.001
  const double kept = std::round(per_minute / least) * least;
  if (kept <= largest && std::abs(kept - per_minute) <= settings_.time_tolerance * 10 * per_minute) return kept;
  if (const double own = step.motions.front().feed; own > largest) {
    refuse_block(*step.block, "emit-feed-range",
                 fmt::format("this block has F{:.6g}, and F under G93 goes from {} to {}", own, to_decimal(least),
                             to_decimal(largest, 3)),
                 "the control does not take this F: under G93 it is one over the time of the block in minutes, so look "
                 "whether G94 was meant");
  }
  refuse_block(
      *step.block, "emit-feed-range",
      fmt::format("a piece of this block would need F{:.6g}, and F under G93 goes from {} to {} in steps of {}",
                  per_minute, to_decimal(least), to_decimal(largest, 3), to_decimal(least)),
      kept > largest ? "let pieces be longer: --step-length, --step-angle, or block_time_ms in the model"
                     : "let pieces be shorter: --step-length, --step-angle");
}

// G93: each piece its share of the time; where the control would lift length x F to its least rate, that piece goes
// under G94 with the rate itself.
void PiecePlanner::choose_inverse_times(const Step& step, double seconds, OutputState& control) {
  double spent = 0;
  for (Piece& piece : pieces_) {
    const double minutes = piece.share * seconds / kMinute;
    const double rate = piece.length / minutes;
    piece.leaves_inverse_time = rate < dialect_.feed_rate_min && piece.length > 0;
    const FeedMode mode = piece.leaves_inverse_time ? FeedMode::per_minute : FeedMode::inverse_time;
    piece.restates_mode = mode != control.feed_mode;
    control.feed_mode = mode;
    const bool whole = pieces_.size() == 1 && !piece.leaves_inverse_time;
    const double feed = piece.leaves_inverse_time ? rounded_feed(step, rate) : inverse_time(step, 1 / minutes);
    const bool keep = whole && !differs(step.motions.front().feed, feed, settings_.time_tolerance);
    if (!keep && piece.leaves_inverse_time) state_feed(step, piece, feed, control);
    if (!keep && !piece.leaves_inverse_time) piece.feed = feed;
    spent += piece.leaves_inverse_time ? piece.length / feed : 1 / (keep ? step.motions.front().feed : feed);
  }
  control.drop_feed();
  seconds_ = spent * kMinute;
}

}  // namespace plumbline::nc
