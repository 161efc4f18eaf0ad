#include "nc/rewrite/emit_pieces.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/rewrite/feed.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {
namespace {

// DC(), ACP() and ACN() tell whoever reads the program that the axis turns without end: DC() is written in their place,
// which goes no way where the axis stands.
bool says_way_round(const Step& step, Axis axis) {
  const Word* const word = find_word(*step.block, letter(axis));
  return word != nullptr && word->mode != WordMode::modal && word->mode != WordMode::absolute &&
         word->mode != WordMode::incremental;
}

// X=AC(5) under G91 stays one: from a place that nobody knows, or after an offset changed, an increment goes elsewhere.
bool is_position(const Step& step, Axis axis) {
  const Word* const word = find_word(*step.block, letter(axis));
  return word != nullptr && word->mode == WordMode::absolute;
}

// F is the speed of X, Y and Z alone, and they move in this block.
bool turns_need_a_way(const Motion& motion) {
  const bool stands = motion.kind == MotionKind::feed && length_mm(motion.to - motion.from) == 0;
  return counts_linear_axes(motion.feed_rule) && motion.feed_mode != FeedMode::inverse_time && !stands;
}

}  // namespace

std::span<Piece> PiecePlanner::plan(const Step& step, std::span<const CorrectedPoint> asked, AxisSet writable,
                                    std::optional<double> seconds, OutputState& control) {
  const Motion& motion = step.motions.front();
  grids_ = words_.grids(step);
  pieces_.clear();
  ends_.clear();
  rounding_mm_ = 0;
  seconds_.reset();
  const AxisWords start = motion.from + control.work_shift(*step.frame);
  const bool has_time = seconds && *seconds > 0;
  points_ = has_time ? held_.hold(step, asked, writable, start, grids_) : asked;
  if (has_time && !settings_.keep_piece_times && turns_need_a_way(motion)) {
    round_joined(step, writable, start);
  } else {
    round_each(step, writable, start);
  }
  AxisWords end_shift;
  for (const Axis axis : kAllAxes)
    end_shift[axis] = motion.known_after.contains(axis) ? ends_.back()[axis] - motion.to[axis] : 0;
  PieceFeeds feeds(dialect_, settings_, step, pieces_, ends_);
  if (has_time) {
    seconds_ = feeds.choose(start, *seconds, control);
  } else {
    feeds.keep(seconds.has_value(), control);
  }
  control.set_work_shift(*step.frame, end_shift);
  return pieces_;
}

void PiecePlanner::round_each(const Step& step, AxisSet writable, const AxisWords& start) {
  AxisWords at = start;
  double waiting = 0;  // share of pieces in which nothing moved
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const AxisWords begin = at;
    const bool only_one = i + 1 == points_.size() && pieces_.empty();
    Piece& piece = pieces_.emplace_back();
    round(step, points_[i], writable, piece, at);
    if (points_[i].arc) piece.arc = arc_words(words_, step, *points_[i].arc, begin);
    piece.share = points_[i].share + waiting;
    waiting = 0;
    if (piece.moved.empty() && !piece.arc && !only_one) {
      waiting = piece.share;
      pieces_.pop_back();
      continue;
    }
    ends_.push_back(at);
  }
  pieces_.back().share += waiting;
}

// F is the speed of X, Y and Z: a turn in whose piece none of them moves goes with the next piece in which one does,
// at the end of the move with the last; where none of the move does, what its correction turns waits.
void PiecePlanner::round_joined(const Step& step, AxisSet writable, const AxisWords& start) {
  joined_.clear();
  double waiting = 0;
  for (const CorrectedPoint& point : points_) {
    const AxisWords begin = ends_.empty() ? start : ends_.back();
    AxisWords at = begin;
    Piece& piece = pieces_.emplace_back();
    round(step, point, writable, piece, at);
    piece.share = point.share + waiting;
    waiting = 0;
    const bool is_last = &point == &points_.back();
    if (length_mm(at - begin) > 0 || (is_last && pieces_.size() == 1)) {
      ends_.push_back(at);
      joined_.push_back(point);
      continue;
    }
    waiting = piece.share;
    pieces_.pop_back();
    if (!is_last) continue;
    joined_.back() = point;
    round_last_again(step, writable, start);
  }
  pieces_.back().share += waiting;
  if (pieces_.size() == 1 && length_mm(ends_.back() - start) == 0) hold_turn(step, writable, start);
  points_ = joined_;
}

// The last piece, through the last of the points joined.
void PiecePlanner::round_last_again(const Step& step, AxisSet writable, const AxisWords& start) {
  const double share = pieces_.back().share;
  pieces_.pop_back();
  ends_.pop_back();
  AxisWords at = ends_.empty() ? start : ends_.back();
  Piece& piece = pieces_.emplace_back();
  round(step, joined_.back(), writable, piece, at);
  piece.share = share;
  ends_.push_back(at);
}

// X, Y and Z stand: A, B and C do so too, where it is the correction alone that turns them.
void PiecePlanner::hold_turn(const Step& step, AxisSet writable, const AxisWords& start) {
  CorrectedPoint& point = joined_.back();
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    const double off = start[axis] - (point.nominal[axis] + point.shift[axis]);
    const bool turns = step.motions.front().to[axis] != step.motions.front().from[axis];
    if (turns || std::abs(off) > kMostHeldDeg) return;
  }
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) point.shift[axis] = start[axis] - point.nominal[axis];
  round_last_again(step, writable, start);
}

// Rounds one point, tells which axes move to it, and moves `at` there.
void PiecePlanner::round(const Step& step, const CorrectedPoint& point, AxisSet writable, Piece& piece, AxisWords& at) {
  const AxisWords target = point.nominal + point.shift;
  const bool first = pieces_.size() == 1;
  const AxisSet known_before = first ? step.motions.front().known_before : AxisSet::all();
  piece.direct = dialect_.syntax.word_modes;
  for (const Axis axis : kAllAxes) {
    const std::size_t i = index(axis);
    const WordGrid::Grid& g = *grids_[i];
    piece.digits[i] = g.digits;
    if (!writable.contains(axis)) {
      at[axis] = target[axis];
      continue;
    }
    const bool known = known_before.contains(axis);
    const bool position = first && step.after->incremental && is_position(step, axis);
    if (position) piece.positioned.insert(axis);
    const bool incremental = step.after->incremental && !position;
    const double wanted = (incremental ? target[axis] - at[axis] : target[axis]) / g.per_unit;
    WordGrid::check_word(step, wanted);
    const double value = g.kept(wanted);
    words_.check_digits(step, value, g.digits);
    double end = incremental ? at[axis] + value * g.per_unit : value * g.per_unit;
    const bool endless = !step.after->incremental && step.after->rule_of(axis) != RotaryRule::linear;
    // Downwards to 0 would be -0, which is not the same to every control: the last step is left out.
    if (endless && known && end < at[axis] && within_one_turn(end) == 0) end += g.quantum;
    if (endless) piece.endless.insert(axis);
    piece.value[axis] = value;
    // A word that stands there is written as it is kept now, though the axis was left with more digits.
    const bool says = first && !incremental && step.named.contains(axis) &&
                      (endless ? says_way_round(step, axis) || std::abs(end - at[axis]) > kSamePlace : end != at[axis]);
    if (!known || says || position || std::abs(end - at[axis]) > kMovesFrom * g.quantum * g.per_unit) {
      if (endless) piece.value[axis] = words_.endless_word(step, axis, end, at[axis], known);
      piece.moved.insert(axis);
      at[axis] = end;
    } else if (incremental) {
      piece.value[axis] = 0;
    }
  }
  rounding_mm_ = std::max(rounding_mm_, length_mm(at - target));
}

}  // namespace plumbline::nc
