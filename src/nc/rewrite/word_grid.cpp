#include "nc/rewrite/word_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/language/block_words.hpp"
#include "nc/rewrite/feed.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {
namespace {

constexpr double kArcStart = 1e-7;  // mm

}  // namespace

WordGrid::WordGrid(const Dialect& dialect, const EmitSettings& settings)
    : dialect_(dialect), settings_(settings), most_digits_(dialect.behaviour.most_digits) {
  for (const bool rotary : {false, true}) {
    for (const bool inches : {false, true}) {
      for (const bool incremental : {false, true}) {
        const double per_unit = inches && !rotary ? kMmPerInch : 1.0;
        const int least = rotary ? settings.digits_deg : (inches ? settings.digits_inch : settings.digits_mm);
        const double increment = (rotary ? settings.increment_deg : settings.increment_mm) / per_unit;
        const Kept kept = kept_of_axis_word(dialect.behaviour, rotary, inches, settings.increment_ratio, incremental);
        for (int written = 0; written <= kMostDecimals; ++written) {
          grids_[kind(rotary, inches, incremental)][static_cast<std::size_t>(written)] = {
              written_number(kept, std::max(least, written), increment), per_unit};
        }
      }
    }
  }
}

const WordGrid::Grid& WordGrid::grid(const Step& step, Axis axis, const Word* word) const {
  const int written = word != nullptr ? std::clamp<int>(word->decimals, 0, kMostDecimals) : 0;
  const bool inches = step.after->inches && !is_rotary(axis);
  return grids_[kind(is_rotary(axis), inches, step.after->incremental)][static_cast<std::size_t>(written)];
}

WordGrid::AxisGrids WordGrid::grids(const Step& step) const {
  AxisGrids grids{};
  const std::array<const Word*, kAxes> words = axis_words(*step.block);
  for (const Axis axis : kAllAxes) grids[index(axis)] = &grid(step, axis, words[index(axis)]);
  return grids;
}

const WordGrid::Grid& WordGrid::centre_grid(const Step& step, Axis axis) const {
  const Word* const word = find_word(*step.block, kCentreLetters[index(axis)]);
  const int written = word != nullptr ? std::clamp<int>(word->decimals, 0, kMostDecimals) : 0;
  return grids_[kind(false, step.after->inches, false)][static_cast<std::size_t>(written)];
}

bool WordGrid::stays(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                     const OutputState& control) const {
  const AxisWords standing = control.work_shift(*step.frame);
  const Motion& motion = step.motions.front();
  const bool arc = motion.kind == MotionKind::arc;
  for (const Axis axis : kAllAxes) {
    if (!writable.contains(axis)) continue;
    const Grid& g = grid(step, axis, find_word(*step.block, letter(axis)));
    const double half = g.quantum * g.per_unit / 2;
    // An arc may be none at all where its start is a little off its end, and an axis turn all the way round.
    const double allowed = counts_turns(step, axis) ? kSamePlace : arc ? std::min(half, kArcStart) : half;
    const bool stands_somewhere = motion.known_before.contains(axis) || counts_turns(step, axis);
    if (depends_on_start(step, axis) && stands_somewhere && std::abs(standing[axis]) >= allowed) return false;
    for (const CorrectedPoint& point : points) {
      if (std::abs(point.shift[axis]) >= half) return false;
    }
  }
  return keeps_time(step, standing);
}

AxisWords WordGrid::half_quanta(const Step& step, const OutputState& control) const {
  const AxisWords stands = step.motions.front().from + control.work_shift(*step.frame);
  const AxisGrids grids = this->grids(step);
  AxisWords half;
  for (const Axis axis : kAllAxes) {
    const Grid& g = *grids[index(axis)];
    const double quantum = g.quantum * g.per_unit;
    const double between = std::abs(stands[axis] - g.kept(stands[axis] / g.per_unit) * g.per_unit);
    half[axis] = (between > kSamePlace ? 0.5 + kMovesFrom : 0.5) * quantum;
  }
  return half;
}

// A cut whose start was rounded to another place is longer or shorter: one of some micrometres needs another F.
bool WordGrid::keeps_time(const Step& step, const AxisWords& standing) const {
  const Motion& motion = step.motions.front();
  if (motion.kind != MotionKind::feed || motion.feed_mode == FeedMode::inverse_time) return true;
  AxisWords off;
  for (const Axis axis : kAllAxes) {
    if (motion.known_before.contains(axis) && !depends_on_start(step, axis)) off[axis] = standing[axis];
  }
  const AxisWords travel = motion.to - motion.from;
  const auto length = [&](const AxisWords& d) {
    return feed_length(length_mm(d), d, motion.feed_rule, motion.mm_per_unit).value_or(0);
  };
  const double before = length(travel);
  return before <= kSamePlace || !differs(length(travel - off), before, settings_.time_tolerance);
}

// Its absolute words are counted from where it stands.
bool WordGrid::counts_turns(const Step& step, Axis axis) {
  return step.named.contains(axis) && !step.after->incremental && step.after->rule_of(axis) != RotaryRule::linear;
}

bool WordGrid::depends_on_start(const Step& step, Axis axis) {
  const bool all =
      step.after->incremental || step.end_words == EndWords::polar || step.motions.front().kind == MotionKind::arc;
  if (all || !step.named.contains(axis) || counts_turns(step, axis)) return true;
  const Word* const word = find_word(*step.block, letter(axis));
  return word != nullptr && word->mode == WordMode::incremental;
}

// The word that sends an axis which turns without end to `to`. Where it stands may not be known: then the way round is
// the one that the original goes.
double WordGrid::endless_word(const Step& step, Axis axis, double to, double left_at, bool is_known) const {
  const std::optional<double> from = is_known ? std::optional(left_at) : std::nullopt;
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
    if (word && written != nullptr) refuse_way_round(step, axis, rule, *word, written->value, left_at);
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

// Nobody knows where the axis stands; but it may well stand where it was left, and then the corrected word must not
// turn it all the way round where the original's does not.
void WordGrid::refuse_way_round(const Step& step, Axis axis, RotaryRule rule, double word, double written,
                                double left_at) {
  const auto way = [&](double to, double from) { return rotary_end(rule, to, std::signbit(to), from) - from; };
  if (std::abs(way(word, left_at) - way(written, step.motions.front().from[axis])) < kFullTurn / 2) return;
  refuse_block(*step.block, "emit-rotary-word",
               fmt::format("where {} stands is not known here; if it is where it was left, its corrected word turns it "
                           "all the way round",
                           letter(axis)),
               "say that the axes stay where they are (--keeps-position, as in --keeps-position M0), or move it by "
               "increments (G91)");
}

bool WordGrid::rounds_to_zero(const Step& step, const AxisWords& shift, AxisSet writable) const {
  const AxisGrids grids = this->grids(step);
  return std::all_of(kAllAxes.begin(), kAllAxes.end(), [&](Axis axis) {
    const Grid& g = *grids[index(axis)];
    return !writable.contains(axis) || std::abs(shift[axis]) < g.quantum * g.per_unit / 2;
  });
}

// Numbers that cannot be written with all their digits.
void WordGrid::refuse_word(const Step& step, double value) {
  refuse_block(*step.block, "emit-out-of-range", fmt::format("this block would need the number {:.6g}", value),
               "check the words and offsets of the block: no machine goes there");
}

void WordGrid::count_digits(const Step& step, double value, int decimals) const {
  if (std::abs(value) < std::pow(10, most_digits_ - decimals)) return;
  refuse_block(*step.block, "emit-out-of-range",
               fmt::format("this block would need the number {:.3f}, and {} takes {} digits", value, dialect_.name,
                           most_digits_),
               "check the words and offsets of the block: no machine goes there");
}

double WordGrid::rounded(const Step& step, Axis axis, double value) const {
  check_word(step, value);
  return grids(step)[index(axis)]->kept(value);
}

double WordGrid::offset_word(const Step& step, Axis axis, double value) const {
  if (dialect_.behaviour.keeps_increment) return rounded(step, axis, value);
  check_word(step, value);
  return value;
}

}  // namespace plumbline::nc
