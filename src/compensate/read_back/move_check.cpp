#include "compensate/read_back/move_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "compensate/read_back/difference.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kEndless = 3.2;      // of an axis that turns without end: -0 is stepped over
constexpr double kSameDwell = 1e-6;   // s
constexpr double kSameCentre = 5e-5;  // mm
constexpr double kNoise = 1e-10;      // of a number that was read

std::string_view name_of(nc::MotionKind kind) {
  switch (kind) {
    case nc::MotionKind::rapid:
      return "a rapid";
    case nc::MotionKind::feed:
      return "a straight cut";
    case nc::MotionKind::arc:
      return "an arc";
    case nc::MotionKind::probe:
      return "a probing move";
    case nc::MotionKind::dwell:
      break;
  }
  return "a dwell";
}

// In the axes of the words, which is where the control rounds.
bool is_at(const AxisWords& point, const AxisWords& read, const IntendedMove& move, const nc::Step& step,
           bool has_words) {
  const AxisWords off = step.frame->turned_back(read - point);
  return std::all_of(kAllAxes.begin(), kAllAxes.end(), [&](Axis axis) {
    if (!move.motion.known_after.contains(axis)) return true;
    const bool endless = step.after->rule_of(axis) != nc::RotaryRule::linear;
    const double halves = endless ? kEndless : has_words && step.named.contains(axis) ? 1 : kLoose;
    return std::abs(off[axis]) <= halves * move.tolerance[axis];
  });
}

// Of a number with so many decimals.
double last_digit(int decimals) {
  return decimals <= kMostDecimals ? 1 / power_of_ten(decimals) : std::pow(10, -decimals);
}

// A control cuts digits off that it does not keep: what was written must be what it reads.
void check_words(const IntendedMove& meant, const nc::Step& step) {
  for (const nc::Word& word : step.block->words) {
    const std::optional<Axis> axis = axis_of(word.letter);
    if (!axis) continue;
    const double increment = meant.increment[*axis];
    const double kept = increment > 0 ? std::round(word.value / increment) * increment : word.value;
    const double digit = meant.digit[*axis];
    const double noise = kNoise * std::max(1.0, std::abs(word.value));
    const bool has_digits = last_digit(word.decimals) > digit / 2;
    if (has_digits && std::abs(kept - word.value) <= digit / 2 + noise) continue;
    throw Difference{fmt::format("it has {}, and the control keeps steps of {}", step.block->at(word.span),
                                 to_decimal(std::max(increment, digit)))};
  }
}

// Straight, or along the arc that was meant: its plane, turns and centre.
bool has_kind(const IntendedMove& meant, const std::optional<nc::Arc>& arc, const nc::Motion& motion) {
  if (!arc) return motion.kind == (path::is_cut(meant.motion.kind) ? nc::MotionKind::feed : meant.motion.kind);
  if (motion.kind != nc::MotionKind::arc || motion.arc.plane != arc->plane || motion.arc.turns != arc->turns)
    return false;
  const nc::PlaneAxes plane = nc::axes_of(arc->plane);
  const auto is_there = [&](Axis axis) {
    return std::abs(arc->centre_mm[index(axis)] - motion.arc.centre_mm[index(axis)]) <= meant.centre_tolerance;
  };
  return is_there(plane.first) && is_there(plane.second);
}

// `wanted`: where it was to end.
std::string what_differs(const IntendedMove& meant, const AxisWords& wanted, const nc::Motion& motion) {
  const bool pieces = meant.form == IntendedMove::Form::pieces;
  const bool straight = pieces && path::is_cut(meant.motion.kind) && !meant.has_arcs;
  const nc::MotionKind kind = straight ? nc::MotionKind::feed : meant.has_arcs ? motion.kind : meant.motion.kind;
  if (kind != motion.kind || meant.motion.in_machine_coordinates != motion.in_machine_coordinates) {
    return fmt::format("it has {} where {} was meant", name_of(motion.kind), name_of(kind));
  }
  if (kind == nc::MotionKind::dwell) {
    return fmt::format("it waits {} s, and {} s were meant", to_decimal(motion.dwell_s, 6),
                       to_decimal(meant.motion.dwell_s, 6));
  }
  for (const Axis axis : kAllAxes) {
    if (meant.motion.known_after.contains(axis) != motion.known_after.contains(axis)) {
      return fmt::format("where {} stands is known only in one of the two", letter(axis));
    }
    if (!meant.motion.known_after.contains(axis)) continue;
    if (std::abs(wanted[axis] - motion.machine[axis]) <= kLoose * meant.tolerance[axis]) continue;
    return fmt::format("it ends at {}{} of the machine, and {} was meant", letter(axis),
                       to_decimal(motion.machine[axis], 6), to_decimal(wanted[axis], 6));
  }
  if (kind == nc::MotionKind::arc) return "its arc is another one";
  return "it ends elsewhere than was meant";
}

}  // namespace

void MoveCheck::begin(const IntendedBatch& batch, const IntendedBlock& block) {
  batch_ = &batch;
  block_ = &block;
  move_ = block.first_move;
  last_move_ = move_ + block.moves;
  point_ = 0;
  has_moved_ = stops_ = false;
  times_.begin_move();
}

void MoveCheck::take(const nc::Step& step) {
  step_ = &step;
  for (const nc::Motion& motion : step.motions) take_motion(motion);
  if (!step.motions.empty()) stops_ = step.after->path_control == nc::PathControl::exact_stop;
}

void MoveCheck::end() {
  while (move_ < last_move_) finish_move();
}

// Its points need no piece: the control stands there already, as far as it can tell.
bool MoveCheck::is_reached(const IntendedMove& move, std::size_t point) const {
  if (move.motion.kind == nc::MotionKind::dwell) return false;
  if (move.form == IntendedMove::Form::kept && path::stands(move.motion)) return true;
  if (move.has_arcs && batch_->arcs[move.first_arc + point]) return false;
  return stands_known_.contains(move.motion.known_after) &&
         is_at(batch_->points[move.first_point + point], stands_, move, *step_, false);
}

void MoveCheck::take_motion(const nc::Motion& motion) {
  if (motion.kind != nc::MotionKind::dwell) has_moved_ = true;
  while (move_ < last_move_) {
    const IntendedMove& meant = batch_->moves[move_];
    const bool taken = meant.form == IntendedMove::Form::kept ? take_kept(meant, motion) : take_piece(meant, motion);
    if (taken) return;
    if (!may_finish(meant)) break;
    finish_move();
  }
  const bool enters = block_->spindle_cycle && motion.kind == nc::MotionKind::rapid;
  if (!path::stands(motion) && !enters) differ(motion);
  go_to(motion);
}

void MoveCheck::go_to(const nc::Motion& motion) {
  if (motion.kind == nc::MotionKind::dwell) return;
  stands_ = motion.machine;
  stands_known_ = motion.known_after;
}

void MoveCheck::differ(const nc::Motion& motion) const {
  if (move_ >= last_move_) throw Difference{fmt::format("it has {} more than was meant", name_of(motion.kind))};
  const IntendedMove& meant = batch_->moves[move_];
  const AxisWords& wanted = batch_->points[meant.first_point + std::min(point_, meant.points - 1)];
  throw Difference{what_differs(meant, wanted, motion)};
}

bool MoveCheck::take_kept(const IntendedMove& meant, const nc::Motion& motion) {
  const nc::Motion& original = meant.motion;
  if (original.kind != motion.kind || original.in_machine_coordinates != motion.in_machine_coordinates) return false;
  if (original.kind == nc::MotionKind::dwell) return take_dwell(meant, motion);
  const AxisWords& wanted = batch_->points[meant.first_point];
  if (!(original.known_after == motion.known_after) || !is_at(wanted, motion.machine, meant, *step_, true))
    return false;
  if (original.kind == nc::MotionKind::arc) {
    bool same = original.arc.plane == motion.arc.plane && original.arc.turns == motion.arc.turns;
    for (std::size_t i = 0; i < original.arc.centre_mm.size(); ++i) {
      same = same && std::abs(original.arc.centre_mm[i] - motion.arc.centre_mm[i]) <= kSameCentre;
    }
    if (!same) return false;
  }
  if (original.kind == nc::MotionKind::probe && std::abs(original.feed - motion.feed) > 1e-6 * original.feed) {
    throw Difference{"it probes at another feed"};
  }
  reach(meant, wanted, motion);
  times_.end_move(meant, block_->place(), figures_);
  leave_move();
  return true;
}

bool MoveCheck::take_dwell(const IntendedMove& meant, const nc::Motion& motion) {
  const double counted = dialect_.behaviour.dwell_p_s == 1 ? 0 : dialect_.behaviour.dwell_p_s / 2;
  if (std::abs(meant.motion.dwell_s - motion.dwell_s) > kSameDwell + counted) return false;
  if (meant.counts) figures_.seconds += motion.dwell_s;
  ++move_;
  return true;
}

bool MoveCheck::take_piece(const IntendedMove& meant, const nc::Motion& motion) {
  const bool cuts = path::is_cut(meant.motion.kind);
  if (motion.in_machine_coordinates) return false;
  if (!(meant.motion.known_after == motion.known_after) && point_ + 1 == meant.points) return false;
  std::size_t at = point_;
  while (at < meant.points && !is_at(batch_->points[meant.first_point + at], motion.machine, meant, *step_, true)) {
    if (!is_reached(meant, at)) return false;
    ++at;
  }
  if (at == meant.points) return false;
  if (!has_kind(meant, meant.has_arcs ? batch_->arcs[meant.first_arc + at] : std::nullopt, motion)) return false;
  if (point_ > 0 && stops_ && cuts) throw Difference{"the control would stop between its pieces"};
  reach(meant, batch_->points[meant.first_point + at], motion);
  point_ = at + 1;
  return true;
}

void MoveCheck::reach(const IntendedMove& meant, const AxisWords& wanted, const nc::Motion& motion) {
  if (meant.corrected) check_words(meant, *step_);
  times_.spend(meant, motion);
  note_point(meant, wanted, motion);
  go_to(motion);
}

void MoveCheck::note_point(const IntendedMove& meant, const AxisWords& wanted, const nc::Motion& motion) {
  if (motion.kind == nc::MotionKind::probe || motion.in_machine_coordinates) return;
  ++figures_.points;
  if (!meant.corrected) return;
  AxisWords off;
  for (const Axis axis : kAllAxes) {
    if (motion.known_after.contains(axis)) off[axis] = motion.machine[axis] - wanted[axis];
  }
  figures_.rounding_mm.take(length_mm(off), block_->place());
}

bool MoveCheck::may_finish(const IntendedMove& meant) const {
  if (meant.form == IntendedMove::Form::kept) return is_reached(meant, 0);
  for (std::size_t i = point_; i < meant.points; ++i) {
    if (!is_reached(meant, i)) return false;
  }
  return true;
}

void MoveCheck::finish_move() {
  const IntendedMove& meant = batch_->moves[move_];
  if (!may_finish(meant)) {
    const std::size_t at = std::min(point_, meant.points - 1);
    const AxisWords& wanted = batch_->points[meant.first_point + at];
    throw Difference{fmt::format("{} is missing, which was to end at X{} Y{} Z{} of the machine",
                                 name_of(meant.motion.kind), to_decimal(wanted[Axis::X], 6),
                                 to_decimal(wanted[Axis::Y], 6), to_decimal(wanted[Axis::Z], 6))};
  }
  times_.end_move(meant, block_->place(), figures_);
  leave_move();
}

void MoveCheck::leave_move() {
  ++move_;
  point_ = 0;
  times_.begin_move();
}

}  // namespace plumbline::compensate
