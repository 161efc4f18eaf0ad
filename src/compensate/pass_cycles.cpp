// Cycles: left as they are, written out move by move, or kept with their hole shifted.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "compensate/figures.hpp"
#include "compensate/guard.hpp"
#include "compensate/pass.hpp"
#include "path/duration.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kStandsOnR = 1e-6;  // mm
// The length over which a turn that varies along a hole counts like a shift that does.
constexpr double kTurnOverMm = 100;

// How many motions of a block of one hole come before those of the hole itself.
std::size_t way_to_hole(const nc::Step& step) {
  const nc::Hole& hole = step.holes.front();
  return step.motions.size() - (hole.end - hole.begin);
}

}  // namespace

void Pass::process_cycle(const nc::Step& step) {
  const nc::Step& plain = *plain_.plain(step, true);
  const std::span<const nc::Step* const> moves = written_.of(plain);
  // A cycle that goes on with the words of the one before it, which was written out.
  const bool ended = step.call != nullptr ? step.after->modal_call && !emitter_.control().modal_call
                                          : step.before->motion == nc::MotionMode::cycle &&
                                                emitter_.control().motion != nc::MotionMode::cycle;
  const bool goes_on = emitter_.changed() && ended;
  const bool point_by_point = step.ends_nurbs && form_ == nc::Form::unrolled;  // its points were left out
  if (!goes_on && !point_by_point && cycle_stays(step, moves)) {
    copy(step, true);
    note_cycle(step);
    return;
  }
  if (step.ends_nurbs && !point_by_point) {
    must_unroll_ = true;  // the blocks of its points are behind us
    return;
  }
  refuse_unless_in_place(step, goes_on);
  emitter_.begin_group(step);
  stands_at_ = step.motions.empty() ? 0 : step.motions.front().from[nc::axes_of(step.after->plane).third];
  for (const nc::Step* const move : moves) {
    if (move->cycle != nc::CycleForm::none) {
      process_hole(*move);
    } else {
      process(*move);
    }
  }
  emitter_.end_group(step);
}

bool Pass::cycle_stays(const nc::Step& step, std::span<const nc::Step* const> moves) {
  if (!emitter_.stands_true(step, writable())) return false;
  return std::all_of(moves.begin(), moves.end(), [&](const nc::Step* const move) {
    if (move->cycle != nc::CycleForm::none) {
      hole_points(*move);
      return std::all_of(points_.begin(), points_.end(), [&](const nc::CorrectedPoint& point) {
        return emitter_.rounds_to_zero(*move, point.shift, writable());
      });
    }
    if (!is_corrected(*move)) return true;
    find_points(*move);
    return emitter_.stays(*move, points_, writable());
  });
}

// A rigid tap ends at any other motion: its blocks stay as they are, their holes shifted.
void Pass::refuse_unless_in_place(const nc::Step& step, bool goes_on) const {
  if (step.cycle != nc::CycleForm::spindle || !dialect_.behaviour.fanuc_cycles) return;
  const Place place = place_of(*step.block, step.block->file);
  if (goes_on) {
    refuse("compensate-cycle", "this cycle goes on from one that is written out as moves",
           "write G80 before it, and state all of its words", place);
  }
  if (nc::WrittenMoves::is_one_hole(step)) return;
  refuse("compensate-cycle",
         "a cycle that works the spindle is shifted hole by hole, and this block makes several, or counts from the one "
         "before it (G91, K, L)",
         "write each hole into a block of its own, with G90", place);
}

// The spindle leads: such a block cannot be divided, and its K would have to follow the corrections.
void Pass::process_synchronised(const nc::Step& step) {
  bool stays = emitter_.stands_true(step, writable());
  for (const nc::Motion& motion : step.motions) {
    has_position(step, motion.known_before & motion.known_after, true);
    const nc::CorrectedPoint point =
        corrected_point(step, target_of(step, {motion.to, {}, {}}, std::nullopt), motion.to);
    stays = stays && emitter_.rounds_to_zero(step, point.shift, writable());
  }
  if (stays) return pass(step);
  refuse("compensate-synchronised", "a move that follows the spindle (G33, G33.1) is not compensated",
         "tap with G84, which is shifted as a whole, or mill the thread", place_of(*step.block, step.block->file));
}

void Pass::find_points(const nc::Step& step) {
  const nc::Motion& motion = step.motions.front();
  if (motion.kind == nc::MotionKind::rapid) return rapid_point(step);
  const path::Curve curve(motion);
  feed_points(step, curve, clock_seconds(motion, path::duration(motion, curve, dialect_)));
}

// Corrections from where the hole begins to its bottom. The tool goes down and up: without friction.
void Pass::hole_points(const nc::Step& step) {
  const nc::Hole& hole = step.holes.front();
  const nc::Motion& motion = step.motions[way_to_hole(step)];
  has_position(step, motion.known_before & motion.known_after, true);
  points_.clear();
  for (const AxisWords& words : hole_places(step, hole, motion.to, settings_.step.length_mm)) {
    points_.push_back(corrected_point(step, target_of(step, {words, {}, {}}, std::nullopt), words));
  }
}

void Pass::process_hole(const nc::Step& step) {
  hole_points(step);
  AxisWords mean;
  for (const nc::CorrectedPoint& point : points_) mean += point.shift;
  for (double& value : mean.values) value /= static_cast<double>(points_.size());
  for (const nc::CorrectedPoint& point : points_) {
    const AxisWords off = point.shift - mean;
    const double varies = std::max(length_mm(off), largest_turn_deg(off) * kDeg * kTurnOverMm);
    note_point(step, point);
    if (varies <= settings_.cycle_tolerance_mm) continue;
    refuse(
        "compensate-cycle",
        fmt::format("the correction varies by {:.4f} mm along this hole, and a cycle that works the spindle can only "
                    "be shifted as a whole",
                    varies),
        "allow more with --cycle-tolerance, or drill a shorter hole", place_of(*step.block, step.block->file));
  }
  check_way_to_hole(step, mean);
  check_level_of_hole(step, mean);
  stands_at_ = step.holes.front().clear;
  const nc::EmittedMove move = emitter_.hole(step, mean);
  intention_.shift(step, mean);
  note_move(step, move, std::nullopt);
  note_cycle(step);
}

// The rapids over the hole and down to it, where they are part of its block.
void Pass::check_way_to_hole(const nc::Step& step, const AxisWords& shift) const {
  for (std::size_t i = 0; i < way_to_hole(step); ++i) {
    const nc::Motion& motion = step.motions[i];
    if (!motion.known_before.contains(writable())) continue;
    const Target from = target_of(step, {motion.from, {}, {}}, std::nullopt);
    const Target to = target_of(step, {motion.to, {}, {}}, std::nullopt);
    const AxisWords commanded = step.frame->to_pose(motion.to + shift);
    refuse_violations(check_way(corrector_, model_.limits, from, to, commanded), *step.block, step.block->file);
  }
}

// A cycle of an OSP is read for a tool that stands where it goes back to: on R, which is shifted with the hole (M54),
// or on the level of G71, which is not (M53). One of a Fanuc that begins on R goes back to R. The correction may have
// shifted the tool otherwise.
void Pass::check_level_of_hole(const nc::Step& step, const AxisWords& shift) const {
  const nc::Hole& hole = step.holes.front();
  const bool levels = dialect_.behaviour.return_levels;
  const bool goes_to_start = !levels && dialect_.behaviour.fanuc_cycles && !step.after->retract_to_r;
  if (!levels && !(goes_to_start && hole.clear == hole.r)) return;
  const Axis normal = nc::axes_of(step.after->plane).third;
  const bool to_r = goes_to_start || step.after->retract_to_r || hole.clear == hole.r;
  const double r = hole.r + shift[normal];
  const double level = to_r ? r : hole.clear;
  const double stands = stands_at_ + emitter_.control().work_shift(*step.frame)[normal];
  if (std::abs(stands - level) < (goes_to_start ? kStandsOnR : nc::kSameLevel) && r <= level) return;
  refuse("compensate-cycle",
         fmt::format("the correction puts the tool {:.3f} mm off {}, on which it stands in the original: how it comes "
                     "to the hole and back from there was found in no source",
                     stands - level, to_r ? "R" : "the level of G71"),
         goes_to_start ? "move the tool above R before the cycle, or write G99"
         : to_r        ? "state all six axes before the cycle, so that the move to above the hole is corrected as well"
                       : "drill the hole with moves (G0, G1), or where the correction is smaller",
         place_of(*step.block, step.block->file));
}

// Times that the rewriting keeps.
void Pass::note_cycle(const nc::Step& step) {
  for (const nc::Motion& motion : step.motions) {
    double seconds = motion.dwell_s;
    if (motion.kind == nc::MotionKind::feed) {
      seconds = clock_seconds(motion, path::duration(motion, path::Curve(motion), dialect_)).value_or(0);
    }
    summary_.seconds_before += seconds;
    summary_.seconds_after += seconds;
  }
}

}  // namespace plumbline::compensate
