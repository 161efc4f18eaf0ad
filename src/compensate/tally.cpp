#include "compensate/tally.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "compensate/move_reader.hpp"
#include "nc/sequence/program_ends.hpp"
#include "path/duration.hpp"
#include "path/figures.hpp"
#include "physics/effect_info.hpp"

namespace plumbline::compensate {
namespace {

constexpr std::uint64_t kReplayAll = 256;   // corrected moves at the begin
constexpr std::uint64_t kReplayEvery = 16;  // after them
constexpr std::uint64_t kOffsetEvery = 64;  // what costs three corrections, and changes little from place to place
constexpr double kAlmost = 1 - 1e-6;        // pieces of exactly the time are not below it
constexpr double kOffsetProbeMm = 1;
constexpr std::size_t kSamples = 8;     // samples, three poses each: whole packs, whatever the processor has
constexpr double kLeastDriftMm = 1e-5;  // in an hour

// What became of an arc.
void note_arc(const WrittenMove& written, const SourceLine& at, ArcFigures& arcs) {
  const std::size_t pieces = written.pieces.size();
  const bool has_arcs = std::any_of(written.pieces.begin(), written.pieces.end(),
                                    [](const SentPiece& piece) { return piece.arc.has_value(); });
  if (!written.changed || (has_arcs && pieces == 1)) {
    ++arcs.stayed;
  } else if (has_arcs) {
    ++arcs.split;
    arcs.blocks += pieces;
    arcs.most_blocks.take(static_cast<double>(pieces), at);
  } else {
    ++arcs.straight;
  }
}

}  // namespace

void Tally::take_block(const nc::Step& step) {
  ++summary_.blocks;
  if (!negative_length_ && !step.motions.empty() && step.frame->tool[Axis::Z] < 0) {
    negative_length_ = {step.frame->tool[Axis::Z], place_of(step)};
  }
  const nc::Block& block = *step.block;
  const bool percent = block.kind == nc::LineKind::percent;
  const bool ends = percent || nc::returns_from_file(step) || step.stop == nc::StopByVariable::alarm;
  if (block.kind == nc::LineKind::ignored || (block.words.empty() && !ends)) return;
  ended_ = ends || std::any_of(block.words.begin(), block.words.end(), [&](const nc::Word& word) {
             const nc::CodeRow* const row = word.letter == 'M' ? dialect_.row_of(word) : nullptr;
             return row != nullptr && (row->action == nc::Action::end || row->action == nc::Action::end_program);
           });
  last_line_ = block.line;
}

void Tally::take_kept_time(double seconds) {
  summary_.seconds_before += seconds;
  summary_.seconds_after += seconds;
}

void Tally::take_cycle(const nc::Step& step) {
  for (const nc::Motion& motion : step.motions) {
    const bool by_the_clock = motion.feed_mode != nc::FeedMode::per_revolution;
    double seconds = motion.dwell_s;
    if (motion.kind == nc::MotionKind::feed) {
      const std::optional<double> duration = path::duration(motion, path::Curve(motion), dialect_);
      seconds = by_the_clock ? duration.value_or(0) : 0;
      if (!by_the_clock || !duration) ++summary_.untimed_moves;
    }
    take_kept_time(seconds);
  }
}

void Tally::take_massless_tool(const nc::Step& step) {
  massless_tools_.try_emplace(step.after->tool_in_spindle, place_of(step));
}

void Tally::take_rapid(const CorrectedMove& corrected, const WrittenMove& written) {
  const SourceLine at = corrected.move.path.place();
  note_point(corrected.points.front(), at);
  note_written(written, std::nullopt, at);
}

void Tally::take_cut(const CorrectedMove& corrected, const WrittenMove& written) {
  const Move& move = corrected.move;
  const SourceLine at = move.path.place();
  for (const nc::CorrectedPoint& point : corrected.points) note_point(point, at);
  note_end(corrected);
  if (move.widened) note_widened(corrected);
  if (settings_.bound.is_asked()) {
    note_bound(corrected);
    if (move.motion->kind == nc::MotionKind::arc) note_arc(written, at, summary_.bound->arcs);
  }
  const bool stops = dialect_.behaviour.starts_with_stops && !move.step->after->path_stated;
  if (stops && written.pieces.size() > 1 && !may_stop_) may_stop_ = place_of(*move.step);
  const bool unstated = dialect_.behaviour.length_set_at_start && !move.step->after->length_stated;
  if (unstated && !length_unstated_) length_unstated_ = place_of(*move.step);
  const bool any_unit = dialect_.behaviour.unit_set_at_start && !move.step->after->unit_stated;
  if (any_unit && !unit_unstated_) unit_unstated_ = place_of(*move.step);
  if (!move.seconds && !goes_nowhere(move.path.curve)) ++summary_.untimed_moves;
  if (written.changed && move.seconds) note_short_pieces(written, *move.seconds, at);
  note_written(written, move.seconds, at);
}

void Tally::take_hole(const CorrectedHole& hole, const nc::EmittedMove& written) {
  const SourceLine at = hole.at->move.path.place();
  for (const nc::CorrectedPoint& point : hole.at->points) note_point(point, at);
  note_written(written, std::nullopt, at);
}

void Tally::note_point(const nc::CorrectedPoint& point, const SourceLine& at) {
  ++summary_.points;
  const double correction = length_mm(point.shift);
  sum_of_squares_ += correction * correction;
  summary_.correction_mm.take(correction, at);
  summary_.correction_deg.take(path::largest_turn_deg(point.shift), at);
}

void Tally::note_written(const nc::EmittedMove& written, std::optional<double> seconds, const SourceLine& at) {
  ++summary_.moves;
  if (written.changed && !written.reworded) ++summary_.changed_blocks;
  summary_.rounding_mm.take(written.rounding_mm, at);
  if (!seconds || *seconds <= 0) return;
  const double after = written.seconds.value_or(*seconds);
  summary_.seconds_before += *seconds;
  summary_.seconds_after += after;
  summary_.time_change.take(std::abs(after / *seconds - 1), at);
}

// Some ends of blocks are played on the model: the figures of the summary are not those of the formula that made them.
void Tally::note_end(const CorrectedMove& corrected) {
  ++cuts_;
  if (cuts_ > kReplayAll && cuts_ % kReplayEvery != 0) return;
  const Move& move = corrected.move;
  const Target target = move.path.target(1, move.seconds);
  if (!sample_) {
    sample_ = target;
    summary_.zero_error = corrector_.error(target);
    summary_.zero_error_line = move.path.line;
    summary_.zero_error_file = move.path.file;
  }
  if (!corrector_.condition_surely_below(target, summary_.condition.value)) {
    summary_.condition.take(corrector_.condition(target), move.path.place());
  }
  if (cuts_ > kReplayAll && cuts_ % kOffsetEvery != 0) return;
  ends_.push_back(corrected.commanded(corrected.points.size() - 1) - target.pose);
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) beside_.emplace_back(target).pose[axis] += kOffsetProbeMm;
  if (ends_.size() == kSamples) note_offset_sensitivity();
}

// How far the offset may be off: the change of the correction with the place of the part.
void Tally::note_offset_sensitivity() {
  corrector_.correct(beside_, corrections_);
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    double squares = 0;
    for (std::size_t i = 3 * end; i < 3 * end + 3; ++i) {
      if (!corrections_[i].converged) continue;  // beyond the edge of what the machine can hold
      const double change = length_mm(corrections_[i].pose - beside_[i].pose - ends_[end]) / kOffsetProbeMm;
      squares += change * change;
    }
    if (squares == 0) continue;
    summary_.offset_shift_for_1um_mm = std::min(summary_.offset_shift_for_1um_mm, kUm / kMm / std::sqrt(squares));
  }
  ends_.clear();
  beside_.clear();
}

// What pieces longer than the steps cost: how far the middle of each lies from where it should be commanded.
void Tally::note_widened(const CorrectedMove& corrected) {
  const Move& move = corrected.move;
  const std::vector<nc::CorrectedPoint>& points = corrected.points;
  const auto count = static_cast<double>(points.size());
  ++summary_.widened_blocks;
  summary_.widened_step_mm.take(move.path.curve.linear_mm() / count, move.path.place());
  std::vector<Target> middles;
  for (std::size_t i = 0; i < points.size(); ++i) {
    middles.push_back(move.path.target((static_cast<double>(i) + 0.5) / count, move.seconds));
  }
  corrector_.correct(middles, corrections_);
  AxisWords begin = move.motion->from + corrected.standing;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const AxisWords wanted = move.path.frame.from_pose(corrections_[i].pose);
    const AxisWords end = points[i].nominal + points[i].shift;
    AxisWords off;
    for (const Axis axis : kAllAxes) off[axis] = (begin[axis] + end[axis]) / 2 - wanted[axis];
    summary_.widening_mm.take(length_mm(off), move.path.place());
    begin = end;
  }
}

void Tally::note_bound(const CorrectedMove& corrected) {
  if (!summary_.bound) summary_.bound.emplace();
  BoundFigures& all = *summary_.bound;
  const BoundOfMove& here = corrected.bound;
  all.kept_mm.take(here.kept_mm, corrected.move.path.place());
  all.kept_deg.take(here.kept_deg, corrected.move.path.place());
  all.at_turns.add(here.at_turns);
  all.by_time.add(here.by_time);
}

void Tally::note_short_pieces(const WrittenMove& written, double seconds, const SourceLine& at) {
  const double block_time = settings_.step.least_time_s;
  ShortPieces& found = summary_.short_pieces;
  for (const SentPiece& piece : written.pieces) {
    const double lasts = piece.share * seconds;
    const bool below_1_ms = lasts < kMs * kAlmost;
    const bool below_block_time = lasts < block_time * kAlmost;
    if (!below_1_ms && !below_block_time) continue;
    if (below_1_ms) ++found.below_1_ms;
    if (below_block_time) ++found.below_block_time;
    if (written.pieces.size() == 1) ++found.whole_blocks;
    if (lasts >= found.least_s) continue;
    found.least_s = lasts;
    found.line = at.line;
    found.file = at.file;
  }
}

Summary Tally::summary() {
  note_offset_sensitivity();
  Summary summary = summary_;
  summary.bytes_before = source_.size();
  if (summary.points > 0) summary.rms_correction_mm = std::sqrt(sum_of_squares_ / static_cast<double>(summary.points));
  warn_of_no_end(summary);
  warn_of_short_pieces(summary);
  warn_of_silent_effects(summary);
  warn_of_massless_tools(summary);
  if (negative_length_) {
    summary.warnings.push_back(
        {"compensate-tool-length",
         fmt::format("the tool's length in force here is {:.6g} mm, so that its tip is taken to lie above the gauge "
                     "point of the spindle",
                     negative_length_->first),
         "if the control holds distances from where tools are touched off to the part, state lengths in the tool "
         "table, "
         "from the gauge point to the tip, and the work offset that goes with them",
         negative_length_->second, Severity::warning});
  }
  if (length_unstated_) {
    summary.warnings.push_back(
        {"compensate-length-unstated",
         "the program does not say which tool length is in force here, and none is taken: which one the control begins "
         "with is set in the machine",
         "write G53 for none, or G56 H and its number, before the first cut", *length_unstated_, Severity::warning});
  }
  if (unit_unstated_) {
    summary.warnings.push_back(
        {"compensate-unit-unstated",
         "the program does not say in which unit it is, and mm is taken: the control takes the unit that is in force "
         "when a program begins",
         "write G21 or G20 before the first move, or say what is in force then: --unit mm or --unit inch",
         *unit_unstated_, Severity::warning});
  }
  if (may_stop_) {
    summary.warnings.push_back(
        {"compensate-stops",
         "the program states no path mode, and where the control begins with G60 it stops after each block: also "
         "after those that stand for this one",
         "write G60, or G64 (G641 to G645), before the first move as the control has it", *may_stop_,
         Severity::warning});
  }
  return summary;
}

void Tally::warn_of_no_end(Summary& summary) const {
  if (ended_ || last_line_ == 0) return;
  Place place;
  place.file = source_.name();
  place.line = last_line_;
  summary.warnings.push_back({"compensate-no-end", "the program ends without M2 or M30",
                              fmt::format("some controls stop with an alarm there, and leave spindle and coolant on: "
                                          "add one, or, if other programs call this file, {}",
                                          nc::how_programs_end(dialect_)),
                              std::move(place), Severity::warning});
}

// A stated block time says what the control takes; a millisecond is what most take.
void Tally::warn_of_short_pieces(Summary& summary) const {
  const ShortPieces& found = summary_.short_pieces;
  const double block_time = settings_.step.least_time_s;
  const std::uint64_t count = block_time > 0 ? found.below_block_time : found.below_1_ms;
  if (count == 0) return;
  Place place;
  place.file = found.file.empty() ? source_.name() : found.file;
  place.line = found.line;
  const std::string limit =
      block_time > 0
          ? fmt::format("the {:.4g} ms that the model gives as the control's time for a block", block_time / kMs)
          : "1 ms";
  const bool own = found.whole_blocks >= count;
  summary.warnings.push_back({"compensate-short-pieces",
                              fmt::format("{} of the output {} shorter than {}, the shortest {:.3g} ms",
                                          count == 1 ? "a piece" : fmt::format("{} pieces", count),
                                          count == 1 ? "is" : "are", limit, found.least_s / kMs),
                              own ? "the program's own blocks are that short: a control that reads blocks more slowly "
                                    "slows down there, with and "
                                    "without the correction"
                                  : "a control that reads blocks more slowly slows down there: take larger steps "
                                    "(--step-length, --step-angle), "
                                    "or state block_time_ms in [control] of the model",
                              std::move(place), Severity::warning});
}

// What the model has and the correction leaves out, since nobody said that it may be counted on.
void Tally::warn_of_silent_effects(Summary& summary) const {
  for (const machine::EffectRow& row : model_.effects) {
    const std::size_t effect = physics::effect_index(row.name);
    if (settings_.dynamic || effect == physics::kEffects || !physics::effect_infos()[effect].dynamic) continue;
    summary.warnings.push_back(
        {"compensate-dynamic", fmt::format("{} of the model is not in the correction", row.name),
         "it depends on how the control shapes the speed; --dynamic counts on the programmed feed", row.place,
         Severity::warning});
  }
  const std::optional<double> drift = sample_ ? corrector_.drift_per_hour_mm(*sample_) : std::nullopt;
  if (settings_.time_s || drift.value_or(0) < kLeastDriftMm) return;
  summary.warnings.push_back(
      {"compensate-time",
       fmt::format(
           "the machine of the model drifts, by {:.2g} um an hour where the program begins to cut, and is taken "
           "as it was when its measurements began",
           *drift * kMm / kUm),
       "say when the program runs: --at-time, in seconds from that moment",
       {},
       Severity::warning});
}

void Tally::warn_of_massless_tools(Summary& summary) const {
  for (const auto& [tool, place] : massless_tools_) {
    const std::optional<double> per_kg = sample_ ? corrector_.error_per_kg_mm(*sample_) : std::nullopt;
    summary.warnings.push_back(
        {"compensate-tool-mass",
         fmt::format("tool {} has no mass{}", tool,
                     per_kg ? fmt::format(": each kg moves the tip by {:.2g} um", *per_kg * kMm / kUm) : std::string()),
         "state mass_kg and centre_of_mass_mm in the tool table (--tools)", place, Severity::warning});
  }
}

}  // namespace plumbline::compensate
