// What a pass notes for the summary.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "compensate/figures.hpp"
#include "compensate/pass.hpp"
#include "physics/effect_info.hpp"

namespace plumbline::compensate {
namespace {

constexpr std::uint64_t kReplayAll = 256;   // corrected moves at the begin
constexpr std::uint64_t kReplayEvery = 16;  // behind them
constexpr double kAlmost = 1 - 1e-6;        // pieces of exactly the time are not below it
constexpr double kOffsetProbeMm = 1;
constexpr double kLeastDriftMm = 1e-5;  // in an hour

}  // namespace

void Pass::note_dwell(const nc::Motion& dwell) {
  summary_.seconds_before += dwell.dwell_s;
  summary_.seconds_after += dwell.dwell_s;
}

// What pieces longer than the steps cost: how far the middle of each lies from where it should be commanded.
void Pass::note_widened(const nc::Step& step, const path::Curve& curve, std::optional<double> seconds) {
  const std::size_t line = step.block->line;
  const auto count = static_cast<double>(points_.size());
  ++summary_.widened_blocks;
  summary_.widened_step_mm.take(curve.linear_mm() / count, line);
  AxisWords begin = step.motions.front().from + emitter_.control().work_shift(*step.frame);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / count;
    const Target target = target_of(step, curve.point(middle), seconds);
    const AxisWords wanted = step.frame->from_pose(corrector_.correct(target).pose);
    const AxisWords end = points_[i].nominal + points_[i].shift;
    AxisWords off;
    for (const Axis axis : kAllAxes) off[axis] = (begin[axis] + end[axis]) / 2 - wanted[axis];
    summary_.widening_mm.take(length_mm(off), line);
    begin = end;
  }
}

void Pass::note_short_pieces(const nc::Step& step, double seconds) {
  const std::span<const nc::Piece> pieces = emitter_.pieces().pieces();
  const double block_time = settings_.step.least_time_s;
  ShortPieces& found = summary_.short_pieces;
  for (const nc::Piece& piece : pieces) {
    const double lasts = piece.share * seconds;
    const bool below_1_ms = lasts < kMs * kAlmost;
    const bool below_block_time = lasts < block_time * kAlmost;
    if (!below_1_ms && !below_block_time) continue;
    if (below_1_ms) ++found.below_1_ms;
    if (below_block_time) ++found.below_block_time;
    if (pieces.size() == 1) ++found.whole_blocks;
    if (lasts >= found.least_s) continue;
    found.least_s = lasts;
    found.line = step.block->line;
  }
}

// A stated block time says what the control takes; a millisecond is what most take.
void Pass::warn_of_short_pieces() {
  const ShortPieces& found = summary_.short_pieces;
  const double block_time = settings_.step.least_time_s;
  const std::uint64_t count = block_time > 0 ? found.below_block_time : found.below_1_ms;
  if (count == 0) return;
  Place place;
  place.file = source_.name();
  place.line = found.line;
  const std::string limit =
      block_time > 0
          ? fmt::format("the {:.4g} ms that the model gives as the control's time for a block", block_time / kMs)
          : "1 ms";
  const bool own = found.whole_blocks >= count;
  summary_.warnings.push_back({"compensate-short-pieces",
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

void Pass::note_point(const nc::Step& step, const nc::CorrectedPoint& point) {
  ++summary_.points;
  const double correction = length_mm(point.shift);
  sum_of_squares_ += correction * correction;
  summary_.correction_mm.take(correction, step.block->line);
  summary_.correction_deg.take(largest_turn_deg(point.shift), step.block->line);
}

void Pass::note_move(const nc::Step& step, const nc::EmittedMove& move, std::optional<double> seconds) {
  ++summary_.moves;
  if (move.changed) ++summary_.changed_blocks;
  summary_.rounding_mm.take(move.rounding_mm, step.block->line);
  if (!seconds || *seconds <= 0) return;
  const double after = move.seconds.value_or(*seconds);
  summary_.seconds_before += *seconds;
  summary_.seconds_after += after;
  summary_.time_change.take(std::abs(after / *seconds - 1), step.block->line);
}

// Some ends of blocks are played on the model: the figures of the summary are not those of the formula that made them.
void Pass::note_end(const nc::Step& step, const Target& target) {
  if (!sample_) {
    sample_ = target;
    summary_.zero_error = corrector_.error(target);
    summary_.zero_error_line = step.block->line;
  }
  ++corrected_moves_;
  if (corrected_moves_ > kReplayAll && corrected_moves_ % kReplayEvery != 0) return;
  const nc::CorrectedPoint& point = points_.back();
  const AxisWords commanded = step.frame->to_pose(point.nominal + point.shift);
  summary_.condition.take(corrector_.condition(target), step.block->line);
  note_offset_sensitivity(target, commanded);
}

// How far the offset may be off: the change of the correction with the place of the part.
void Pass::note_offset_sensitivity(const Target& target, const AxisWords& commanded) {
  const AxisWords correction = commanded - target.pose;
  double squares = 0;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    Target moved = target;
    moved.pose[axis] += kOffsetProbeMm;
    const Corrected corrected = corrector_.correct(moved);
    if (!corrected.converged) continue;  // beyond the edge of what the machine can hold
    const AxisWords there = corrected.pose - moved.pose;
    const double change = length_mm(there - correction) / kOffsetProbeMm;
    squares += change * change;
  }
  if (squares == 0) return;
  summary_.offset_shift_for_1um_mm = std::min(summary_.offset_shift_for_1um_mm, kUm / kMm / std::sqrt(squares));
}

void Pass::note_whether_it_ends(const nc::Step& step) {
  const nc::Block& block = *step.block;
  const bool percent = block.kind == nc::LineKind::percent;
  if (block.kind == nc::LineKind::ignored || (block.words.empty() && !percent)) return;
  ended_ = percent || std::any_of(block.words.begin(), block.words.end(), [&](const nc::Word& word) {
             const nc::CodeRow* const row = word.letter == 'M' ? dialect_.row_of(word) : nullptr;
             return row != nullptr && (row->action == nc::Action::end || row->action == nc::Action::end_program);
           });
  last_line_ = block.line;
}

void Pass::warn_of_no_end() {
  if (ended_ || last_line_ == 0) return;
  Place place;
  place.file = source_.name();
  place.line = last_line_;
  summary_.warnings.push_back({"compensate-no-end", "the program ends without M2 or M30",
                               "some controls stop with an alarm there, and leave spindle and coolant on: add one",
                               std::move(place), Severity::warning});
}

// What the model has and the correction leaves out, since nobody said that it may be counted on.
void Pass::warn_of_silent_effects() {
  for (const machine::EffectRow& row : model_.effects) {
    const std::size_t effect = physics::effect_index(row.name);
    if (settings_.dynamic || effect == physics::kEffects || !physics::effect_infos()[effect].dynamic) continue;
    summary_.warnings.push_back(
        {"compensate-dynamic", fmt::format("{} of the model is not in the correction", row.name),
         "it hangs on how the control shapes the speed; --dynamic counts on the programmed feed", row.place,
         Severity::warning});
  }
  const std::optional<double> drift = sample_ ? corrector_.drift_per_hour_mm(*sample_) : std::nullopt;
  if (settings_.time_s || drift.value_or(0) < kLeastDriftMm) return;
  summary_.warnings.push_back(
      {"compensate-time",
       fmt::format(
           "the machine of the model drifts, by {:.2g} um an hour where the program begins to cut, and is taken "
           "as it was when its measurements began",
           *drift * kMm / kUm),
       "say when the program runs: --at-time, in seconds from that moment",
       {},
       Severity::warning});
}

Summary Pass::summary() {
  for (const nc::InlinedFile& file : emitter_.inlined()) summary_.inlined_files.push_back({file.name, file.hash});
  between_.leave();
  summary_.residual_mm = between_.tip_mm();
  summary_.residual_deg = between_.turned_deg();
  summary_.replayed = between_.plays();
  summary_.unrolled = form_ == nc::Form::unrolled;
  summary_.identical = !emitter_.changed();
  summary_.bytes_before = source_.size();
  if (summary_.points > 0)
    summary_.rms_correction_mm = std::sqrt(sum_of_squares_ / static_cast<double>(summary_.points));
  if (summary_.read_back) {
    summary_.points = summary_.read_back->points;
    summary_.seconds_after = summary_.read_back->seconds;
    summary_.time_change = summary_.read_back->time_change;
    summary_.rounding_mm = summary_.read_back->rounding_mm;
  }
  summary_.assumed_at_zero = pose_.assumed();
  warn_of_no_end();
  warn_of_short_pieces();
  warn_of_silent_effects();
  for (const auto& [tool, place] : massless_tools_) {
    const std::optional<double> per_kg = sample_ ? corrector_.error_per_kg_mm(*sample_) : std::nullopt;
    summary_.warnings.push_back(
        {"compensate-tool-mass",
         fmt::format("tool {} has no mass{}", tool,
                     per_kg ? fmt::format(": each kg moves the tip by {:.2g} um", *per_kg * kMm / kUm) : std::string()),
         "state mass_kg and centre_of_mass_mm in the tool table (--tools)", place, Severity::warning});
  }
  return summary_;
}

}  // namespace plumbline::compensate
