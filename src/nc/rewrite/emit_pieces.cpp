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
  const std::span<const CorrectedPoint> points = has_time ? held_.hold(step, asked, writable, start, grids_) : asked;
  points_ = points;
  AxisWords at = start;
  double waiting = 0;  // share of pieces in which nothing moved
  for (std::size_t i = 0; i < points.size(); ++i) {
    const AxisWords begin = at;
    const bool only_one = i + 1 == points.size() && pieces_.empty();
    Piece& piece = pieces_.emplace_back();
    round(step, points[i], writable, piece, at);
    if (points[i].arc) piece.arc = arc_words(words_, step, *points[i].arc, begin);
    piece.share = points[i].share + waiting;
    waiting = 0;
    if (piece.moved.empty() && !piece.arc && !only_one) {
      waiting = piece.share;
      pieces_.pop_back();
      continue;
    }
    ends_.push_back(at);
  }
  pieces_.back().share += waiting;
  AxisWords end_shift;
  for (const Axis axis : kAllAxes) end_shift[axis] = motion.known_after.contains(axis) ? at[axis] - motion.to[axis] : 0;
  PieceFeeds feeds(dialect_, settings_, step, pieces_, ends_);
  if (has_time) {
    seconds_ = feeds.choose(start, *seconds, control);
  } else {
    feeds.keep(seconds.has_value(), control);
  }
  control.set_work_shift(*step.frame, end_shift);
  return pieces_;
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
