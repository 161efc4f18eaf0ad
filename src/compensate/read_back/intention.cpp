#include "compensate/read_back/intention.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/same_value.hpp"
#include "base/units.hpp"
#include "compensate/read_back/block_effects.hpp"
#include "nc/control/state/kept.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kSameEnd = 1e-8;     // of a move of the original and of what was made of it
constexpr double kNoRounding = 1e-7;  // mm and deg: what nine decimals and the offsets leave of a position

double largest(const AxisWords& a, const AxisWords& b, AxisSet axes) {
  double most = 0;
  for (const Axis axis : kAllAxes) {
    if (axes.contains(axis)) most = std::max(most, std::abs(a[axis] - b[axis]));
  }
  return most;
}

// Whether a word of the block says where the axis ends, wherever it began.
bool is_stated(const nc::Step& step, Axis axis, const nc::Word* word) {
  if (!step.named.contains(axis)) return false;
  if (word != nullptr && word->mode != nc::WordMode::modal) return word->mode != nc::WordMode::incremental;
  return !step.after->incremental;
}

bool is_stated(const nc::Step& step, Axis axis) {
  return is_stated(step, axis, nc::find_word(*step.block, letter(axis)));
}

// Where the last moves of a hole begin, those at the height that it goes back to: on its way down the tool may pass
// there, too.
std::size_t way_back(std::span<const nc::Motion> motions, const nc::Hole& hole, Axis normal) {
  std::size_t back = hole.end;
  const auto is_there = [&](const nc::Motion& motion) {
    return motion.kind == nc::MotionKind::dwell || std::abs(motion.to[normal] - hole.clear) <= nc::kSameHeight;
  };
  while (back > hole.begin && is_there(motions[back - 1])) --back;
  while (back < hole.end && motions[back].kind == nc::MotionKind::dwell) ++back;
  return back;
}

bool same(const IntendedState& state, const nc::Step& step) {
  const nc::Modal& a = state.modal;
  const nc::Modal& b = *step.after;
  return a.plane == b.plane && a.path_control == b.path_control && a.inches == b.inches &&
         a.incremental == b.incremental && a.arc_centre_absolute == b.arc_centre_absolute &&
         a.retract_to_r == b.retract_to_r && a.work_system == b.work_system && a.tool_in_spindle == b.tool_in_spindle &&
         a.tool_of_offset == b.tool_of_offset && a.rotary == b.rotary && a.switches == b.switches &&
         same_value(state.frame, *step.frame);
}

}  // namespace

Intention::Intention(const InputFile& source, const nc::Dialect& dialect, const nc::EmitSettings& emit, bool unrolled,
                     bool notes)
    : source_(source), dialect_(dialect), emit_(emit), unrolled_(unrolled), notes_(notes) {
  for (const bool rotary : {false, true}) {
    for (const bool inches : {false, true}) {
      for (const bool incremental : {false, true}) {
        for (int written = 0; written <= kMostDecimals; ++written) {
          kept_words_[kind(rotary, inches, incremental)][static_cast<std::size_t>(written)] =
              kept_word(rotary, inches && !rotary, incremental, written);
        }
      }
    }
  }
}

void Intention::begin(const nc::Step& original) {
  if (!notes_) return;
  original_ = &original;
  const nc::Block& source = *original.block;
  IntendedBlock block;
  block.line = source.line;
  block.offset = source.offset;
  if (source.file != source_.name()) block.file = source.file;
  block.steers = unrolled_ && (original.flow || original.saves_modes);
  block.spindle_cycle = original.cycle == nc::CycleForm::spindle;
  block.tilted_length = original.tilted_length;
  block.left_out = original.block_delete == nc::BlockDelete::left_out;
  block.number = source.at(source.number);
  block.first_move = batch_.moves.size();
  block.first_effect = batch_.effects.size();
  if (!block.left_out) append_effects(original, dialect_, batch_.effects);
  block.effects = batch_.effects.size() - block.first_effect;
  batch_.blocks.push_back(std::move(block));
}

// What the control keeps of a word, half of it: nothing nearer can be written.
Intention::KeptWord Intention::kept_word(bool rotary, bool inches, bool incremental, int written) const {
  const int least = rotary ? emit_.digits_deg : inches ? emit_.digits_inch : emit_.digits_mm;
  const nc::Kept control =
      nc::kept_of_axis_word(dialect_.behaviour, rotary, inches, emit_.increment_ratio, incremental);
  const double digit = from_ticks(1, std::clamp(std::max(least, written), 0, control.decimals));
  const double unit = inches ? kMmPerInch : 1;
  const double increment = std::max((rotary ? emit_.increment_deg : emit_.increment_mm) / unit, control.quantum);
  const double kept = increment > digit * 1.000001 ? increment + digit : digit;
  return {digit, increment, kept * unit / 2 + kNoRounding, control.decimals};
}

void Intention::note_kept(const nc::Step& step, IntendedMove& move) {
  const std::array<const nc::Word*, kAxes> words = nc::axis_words(*step.block);
  for (const Axis axis : kAllAxes) {
    const nc::Word* const word = words[index(axis)];
    const int written = word != nullptr ? word->decimals : 0;
    const auto& of_kind = kept_words_[kind(is_rotary(axis), step.after->inches, step.after->incremental)];
    const KeptWord& kept = of_kind[static_cast<std::size_t>(std::min(written, kMostDecimals))];
    // An increment keeps what rounding left of the place before it.
    written_[axis] = is_stated(step, axis, word) ? kept.tolerance : std::max(kept.tolerance, written_[axis]);
    move.tolerance[axis] = written_[axis];
    const bool is_cut_off = written > kept.decimals;  // such a word may stand as it is
    move.digit[axis] = is_cut_off ? std::pow(10, -written) : kept.digit;
    move.increment[axis] = is_cut_off ? 0 : kept.increment;
  }
}

void Intention::note_arcs(const nc::Step& step, std::span<const nc::CorrectedPoint> points, IntendedMove& move) {
  move.has_arcs = std::any_of(points.begin(), points.end(), [](const nc::CorrectedPoint& p) { return p.arc; });
  if (!move.has_arcs) return;
  move.first_arc = batch_.arcs.size();
  for (const nc::CorrectedPoint& point : points) batch_.arcs.push_back(point.arc);
  const nc::Kept control =
      nc::kept_of_axis_word(dialect_.behaviour, false, step.after->inches, emit_.increment_ratio, false);
  const double unit = step.after->inches ? kMmPerInch : 1;
  const int digits = std::min(step.after->inches ? emit_.digits_inch : emit_.digits_mm, control.decimals);
  const double increment = std::max(emit_.increment_mm / unit, control.quantum);
  const double digit = from_ticks(1, std::max(digits, 0));
  move.centre_tolerance = (increment > digit * 1.000001 ? increment + digit : digit) * unit / 2 + kNoRounding;
}

IntendedMove& Intention::add(const nc::Motion& motion, IntendedMove::Form form) {
  IntendedMove& move = batch_.moves.emplace_back();
  move.form = form;
  move.motion = motion;
  move.first_point = batch_.points.size();
  return move;
}

AxisWords Intention::work_shift(const nc::Frame& frame) const { return frame.turned_back(away_); }

// Where the control stands after a move that goes through as it stands: axes that the block states are where the
// original has them.
void Intention::move_away(const nc::Step& step, const nc::Motion& motion, bool last) {
  if (step.orienting) {
    away_ = nc::shift_after(*step.orienting, away_);
    return;
  }
  const bool goes_home = motion.in_machine_coordinates && last;
  if (goes_home) {
    for (const Axis axis : kAllAxes) {
      if (step.named.empty() || step.named.contains(axis)) away_[axis] = 0;
    }
    return;
  }
  AxisWords work = work_shift(*step.frame);
  for (const Axis axis : kAllAxes) {
    if (is_stated(step, axis)) work[axis] = 0;
  }
  away_ = step.frame->turned(work);
}

void Intention::keep(const nc::Step& step, bool counts, std::optional<double> seconds) {
  if (!notes_) return;
  if (step.cycle != nc::CycleForm::none && !goes_on_) {
    const Axis normal = nc::axes_of(step.after->plane).third;
    level_away_ = work_shift(*step.frame)[normal];
    level_written_ = written_[normal];
  }
  goes_on_ = step.cycle != nc::CycleForm::none || (goes_on_ && step.motions.empty());
  for (std::size_t i = 0; i < step.motions.size(); ++i) {
    const nc::Motion& motion = step.motions[i];
    if (motion.kind != nc::MotionKind::dwell) move_away(step, motion, i + 1 == step.motions.size());
    IntendedMove& move = add(motion, IntendedMove::Form::kept);
    move.points = 1;
    note_kept(step, move);
    move.counts = counts && !motion.in_machine_coordinates;
    if (seconds) {
      move.seconds = seconds;
    } else if (path::is_cut(motion.kind)) {
      move.seconds = path::duration(motion, path::Curve(motion), dialect_);
    }
    batch_.points.push_back(motion.machine + away_);
  }
}

void Intention::divide(const nc::Step& step, std::span<const nc::CorrectedPoint> points, AxisSet writable,
                       std::optional<double> seconds) {
  if (!notes_) return;
  goes_on_ = false;
  const nc::Motion& motion = step.motions.front();
  IntendedMove& move = add(motion, IntendedMove::Form::pieces);
  move.points = points.size();
  move.loose = AxisSet::all() - writable;
  note_kept(step, move);
  move.seconds = seconds;
  move.corrected = true;
  note_arcs(step, points, move);
  for (const nc::CorrectedPoint& point : points) {
    batch_.points.push_back(step.frame->to_machine(point.nominal + point.shift));
  }
  for (const Axis axis : kAllAxes) {
    const bool moves = motion.known_after.contains(axis) && (writable.contains(axis) || step.frame->tilted);
    away_[axis] = moves ? batch_.points.back()[axis] - motion.machine[axis] : 0;
  }
}

// X and Y of the hole are shifted, and from R on the heights are; the height that it goes back to above R is that at
// which the first of the cycles began.
void Intention::shift(const nc::Step& hole, const AxisWords& by) {
  if (!notes_) return;
  const nc::PlaneAxes axes = nc::axes_of(hole.after->plane);
  const nc::Hole& at = hole.holes.front();
  AxisWords work = work_shift(*hole.frame);
  if (!goes_on_) {
    level_away_ = work[axes.third];
    level_written_ = written_[axes.third];
  }
  goes_on_ = true;
  const std::size_t way_back_begin = way_back(original_->motions, at, axes.third);
  const bool in_place = hole.motions.size() == original_->motions.size();  // the way to the hole is part of its block
  for (std::size_t i = in_place ? 0 : at.approach_end; i < at.end; ++i) {
    const nc::Motion& motion = original_->motions[i];
    work[axes.first] = by[axes.first];
    work[axes.second] = by[axes.second];
    const double end = motion.to[axes.third];
    const double from = motion.from[axes.third] + work[axes.third];
    const bool back = !hole.after->retract_to_r && i >= way_back_begin;
    if (back) {
      // G71 as it is; where the tool came in from below R, the higher of the two
      const bool from_r = !dialect_.behaviour.fanuc_cycles && std::abs(at.clear - at.r) <= nc::kSameHeight;
      if (from_r) level_away_ = std::max(level_away_, by[axes.third]);
      work[axes.third] = dialect_.behaviour.return_levels ? 0 : level_away_;
    } else if (i >= at.approach_end) {
      work[axes.third] = by[axes.third];
    }
    IntendedMove& move = add(motion, IntendedMove::Form::kept);
    move.points = 1;
    move.corrected = true;
    note_kept(hole, move);
    // No word of its block says the height that it comes from, and goes back to.
    const bool at_level = back || i < at.approach_end;
    if (at_level) move.tolerance[axes.third] = std::max(move.tolerance[axes.third], kLoose * level_written_);
    if (path::is_cut(motion.kind)) move.seconds = path::duration(motion, path::Curve(motion), dialect_);
    // Back to where the tool came in, which is not shifted as the hole is
    const double length = std::abs(end - motion.from[axes.third]);
    if (move.seconds && back && length > 0) {
      move.time_share = std::abs(end + work[axes.third] - from) / length;
      *move.seconds *= move.time_share;
    }
    const AxisWords away = hole.frame->turned(work);
    batch_.points.push_back(motion.machine + away);
    away_ = away;
  }
}

// Moves in which nothing moves need not be said.
void Intention::check_all_said() const {
  const IntendedBlock& block = batch_.blocks.back();
  std::size_t said = block.first_move;
  for (const nc::Motion& motion : original_->motions) {
    const auto is_it = [&](const IntendedMove& move) {
      return move.motion.kind == motion.kind && largest(move.motion.to, motion.to, motion.known_after) <= kSameEnd &&
             std::abs(move.motion.dwell_s - motion.dwell_s) <= kSameEnd;
    };
    // Exact stops behind the moves of a cycle that is written out.
    const auto is_stop = [](const IntendedMove& move) {
      return move.motion.kind == nc::MotionKind::dwell && move.motion.dwell_s == 0;
    };
    while (motion.kind != nc::MotionKind::dwell && said < batch_.moves.size() && is_stop(batch_.moves[said])) ++said;
    // A cycle that goes back to where it began is entered from there.
    const bool enters = original_->cycle == nc::CycleForm::spindle;
    while (enters && !path::stands(motion) && said < batch_.moves.size() && !is_it(batch_.moves[said]) &&
           batch_.moves[said].motion.kind == nc::MotionKind::rapid) {
      ++said;
    }
    if (said < batch_.moves.size() && is_it(batch_.moves[said])) {
      ++said;
    } else {
      PLUMBLINE_CHECK(path::stands(motion));
    }
  }
}

void Intention::note_state(const nc::Step& step) {
  if (!has_state_ || !same(state_, step)) {
    state_ = {*step.after, *step.frame};
    batch_.states.push_back(state_);
    has_state_ = true;
  }
  batch_.blocks.back().state = batch_.states.size() - 1;
}

void Intention::end(std::uint64_t output_end) {
  if (!notes_) return;
  IntendedBlock& block = batch_.blocks.back();
  block.output_end = output_end;
  block.moves = batch_.moves.size() - block.first_move;
  check_all_said();
  note_state(*original_);
}

}  // namespace plumbline::compensate
