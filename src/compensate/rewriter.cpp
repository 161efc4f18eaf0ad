#include "compensate/rewriter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::compensate {
namespace {

constexpr double kSameShare = 1e-9;  // of a block's time

}  // namespace

Rewriter::Rewriter(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
                   const nc::EmitSettings& emit, OutputFile& out, WrittenSteps& steps, bool read_back)
    : dialect_(dialect),
      out_(out),
      steps_(steps),
      emitter_(source, dialect, emit, out, steps.unrolled() ? nc::Form::unrolled : nc::Form::in_text_order),
      intention_(source, dialect, emit, steps.unrolled(), read_back) {
  if (read_back) read_back_.emplace(source, dialect, program, emit, out, steps.unrolled());
}

// As long as nothing changed the output is the original, and what it means is not kept.
void Rewriter::end() {
  if (!emitter_.changed() || !read_back_) {
    ++unchanged_blocks_;
    return intention_.start_batch();
  }
  intention_.end(out_.size());
  intention_.batch().unchanged_blocks += std::exchange(unchanged_blocks_, 0);
  read_back_->offer(intention_, emitter_.guard_span());
}

void Rewriter::finish() {
  emitter_.finish();
  if (read_back_ && emitter_.changed()) figures_ = read_back_->finish(intention_, emitter_.guard_span());
}

// Where one block has A, B and C in place of its vector, or its code says that they follow, all after it have; and so
// has what goes on by angles that a vector left (angles_of_vector).
bool Rewriter::writes_vector(const nc::Step& step) const {
  if (step.end_words == nc::EndWords::angles_of_vector) return true;
  if (step.end_words != nc::EndWords::tool_vector) return false;
  return emitter_.changed() ||
         std::any_of(step.block->words.begin(), step.block->words.end(), [&](const nc::Word& word) {
           const nc::CodeRow* const row = nc::is_code(word) ? dialect_.row_of(word) : nullptr;
           return row != nullptr && !row->written_as.empty();
         });
}

void Rewriter::copy(const nc::Step& step, bool counts) {
  if (writes_vector(step)) {
    emitter_.begin_group(step);
    emitter_.copy(steps_.in_other_words(step));
    emitter_.end_group(step);
  } else {
    emitter_.copy(step);
  }
  intention_.keep(step, counts);
}

bool Rewriter::stays(const CorrectedMove& corrected) {
  return emitter_.stays(*corrected.move.step, corrected.points, corrected.move.path.writable());
}

bool Rewriter::are_none(const nc::Step& step, const CorrectedMove& places) const {
  return std::all_of(places.points.begin(), places.points.end(), [&](const nc::CorrectedPoint& point) {
    return emitter_.rounds_to_zero(step, point.shift, places.move.path.writable());
  });
}

bool Rewriter::goes_on_from_written_out(const nc::Step& cycle) const {
  if (!emitter_.changed()) return false;
  const nc::OutputState& control = emitter_.control();
  if (cycle.call != nullptr) return cycle.after->modal_call && !control.modal_call;
  return cycle.before->motion == nc::MotionMode::cycle && control.motion != nc::MotionMode::cycle;
}

// In text order a block with @ and ^, or with a direction of the tool, gets X and Y, or A, B and C, only where it must
// change. A vector rounded to A, B and C may make a short move longer or shorter: its F is looked at anew.
const WrittenMove& Rewriter::write(const CorrectedMove& corrected) {
  const Move& move = corrected.move;
  const nc::Step& step = *move.step;
  const AxisSet writable = move.path.writable();
  nc::CorrectedPoint whole = corrected.points.back();
  whole.share = 1;
  std::span<const nc::CorrectedPoint> points = corrected.points;
  nc::EmittedMove& emitted = written_;
  const bool as_angles = writes_vector(step);
  const bool in_other_words = step.end_words != nc::EndWords::axes && (as_angles || !stays(corrected));
  if (as_angles && move.motion->kind == nc::MotionKind::feed && stays(corrected)) points = {&whole, 1};
  if (in_other_words) {
    emitter_.begin_group(step);
    const nc::Step& other = steps_.in_other_words(step);
    emitted = as_angles ? emitter_.rewrite(other, points, writable, move.duration)
                        : emitter_.move(other, points, writable, move.duration);
    emitter_.end_group(step);
  } else {
    emitted = emitter_.move(step, points, writable, move.duration);
  }
  says_angles_ = says_angles_ || as_angles;
  written_.reworded = says_angles_ && are_none(step, corrected);
  if (emitted.changed) {
    intention_.divide(step, emitter_.pieces().points(), writable, move.duration);
  } else {
    intention_.keep(step, true, move.duration);
  }
  note_pieces(corrected);
  return written_;
}

// What was written for a move that cuts, as the control keeps it.
void Rewriter::note_pieces(const CorrectedMove& corrected) {
  written_.pieces.clear();
  const Move& move = corrected.move;
  if (move.is_rapid()) return;
  const MovePath& path = move.path;
  written_.begin = path.in_base_frame(move.motion->from + corrected.standing);
  if (!written_.changed) {
    const AxisWords end = path.in_base_frame(move.motion->to);
    written_.pieces.push_back({end, end, 1, corrected.signs.back()});
    return;
  }
  const std::span<const nc::Piece> pieces = emitter_.pieces().pieces();
  const std::span<const AxisWords> ends = emitter_.pieces().ends();
  const std::size_t count = corrected.points.size();
  double share = 0;
  double asked_share = 0;
  std::size_t point = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    share += pieces[i].share;
    // Pieces in which nothing moves were joined with the next one.
    for (asked_share += corrected.points[point].share; asked_share < share - kSameShare && point + 1 < count;) {
      asked_share += corrected.points[++point].share;
    }
    const nc::CorrectedPoint& asked = corrected.points[point];
    const AxisWords wanted = path.in_base_frame(asked.nominal + asked.shift);
    written_.pieces.push_back({path.in_base_frame(ends[i]), wanted, pieces[i].share, corrected.signs[point]});
    if (pieces[i].arc) {
      written_.pieces.back().arc = pieces[i].arc->arc;
      written_.pieces.back().proven = corrected.proven[point];
    }
    if (point + 1 < count) ++point;
  }
}

nc::EmittedMove Rewriter::write_hole(const nc::Step& hole, const AxisWords& shift) {
  const nc::EmittedMove move = emitter_.hole(hole, shift);
  intention_.shift(hole, shift);
  return move;
}

void Rewriter::describe(Summary& summary) const {
  for (const nc::InlinedFile& file : emitter_.inlined()) summary.inlined_files.push_back({file.name, file.hash});
  summary.unrolled = steps_.unrolled();
  summary.identical = !emitter_.changed();
  if (const Place* const message = steps_.silenced()) {
    summary.warnings.push_back(
        {"compensate-message", "comments of the program show variables, and the output has none: it shows them no more",
         "what the control shows or logs there is in the output as a comment alone; where an operator or a log file "
         "needs it, write the text without # and expand the program before",
         *message, Severity::warning});
  }
  summary.read_back = figures_;
  if (!figures_) return;
  summary.points = figures_->points;
  summary.seconds_after = figures_->seconds;
  summary.time_change = figures_->time_change;
  summary.rounding_mm = figures_->rounding_mm;
}

}  // namespace plumbline::compensate
