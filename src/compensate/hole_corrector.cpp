#include "compensate/hole_corrector.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kStandsOnR = 1e-6;    // mm
constexpr double kBeside = 1e-6;       // mm
constexpr double kShownInFull = 1e-3;  // mm below which four decimals say too little
// The length over which a turn that varies along a hole counts like a shift that does.
constexpr double kTurnOverMm = 100;

// How many motions of a block of one hole come before those of the hole itself.
std::size_t way_to_hole(const nc::Step& step) {
  const nc::Hole& hole = step.holes.front();
  return step.motions.size() - (hole.end - hole.begin);
}

// Where the tool stands from R to the bottom, in the work system; `above` is any place over it.
std::vector<AxisWords> hole_places(const nc::Step& step, const nc::Hole& hole, const AxisWords& above, double step_mm) {
  const Axis normal = nc::axes_of(step.after->plane).third;
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(hole.r - hole.bottom) / step_mm)));
  std::vector<AxisWords> places(static_cast<std::size_t>(pieces) + 1, above);
  for (int i = 0; i <= pieces; ++i) {
    places[static_cast<std::size_t>(i)][normal] = hole.r + (hole.bottom - hole.r) * i / pieces;
  }
  return places;
}

bool goes_beside(const nc::Motion& motion, const nc::Step& step) {
  const nc::PlaneAxes plane = nc::axes_of(step.after->plane);
  const nc::Hole& hole = step.holes.front();
  const auto is_off = [&](const AxisWords& place) {
    return std::abs(place[plane.first] - hole.first) > kBeside || std::abs(place[plane.second] - hole.second) > kBeside;
  };
  return motion.kind == nc::MotionKind::rapid && (is_off(motion.from) || is_off(motion.to));
}

const nc::Step& step_of(const CorrectedHole& hole) { return *hole.at->move.step; }

}  // namespace

const nc::Motion& HoleCorrector::way_down(const nc::Step& hole) { return hole.motions[way_to_hole(hole)]; }

CorrectedHole HoleCorrector::correct(const Move& down, const nc::Hole& hole, const AxisWords& standing) {
  const std::vector<AxisWords> places = hole_places(*down.step, hole, down.motion->to, settings_.step.length_mm);
  CorrectedHole corrected{&places_.correct_places(down, places, standing), {}};
  const std::vector<nc::CorrectedPoint>& points = corrected.at->points;
  for (const nc::CorrectedPoint& point : points) corrected.shift += point.shift;
  for (double& value : corrected.shift.values) value /= static_cast<double>(points.size());
  return corrected;
}

void HoleCorrector::begin(const nc::Step& cycle) {
  stands_at_ = cycle.motions.empty() ? 0 : cycle.motions.front().from[nc::axes_of(cycle.after->plane).third];
}

void HoleCorrector::check(const CorrectedHole& hole) {
  refuse_varying(hole);
  check_way_to(hole);
  check_level(hole);
  stands_at_ = step_of(hole).holes.front().clear;
}

void HoleCorrector::refuse_varying(const CorrectedHole& hole) const {
  for (const nc::CorrectedPoint& point : hole.at->points) {
    const AxisWords off = point.shift - hole.shift;
    const double varies = std::max(length_mm(off), path::largest_turn_deg(off) * kDeg * kTurnOverMm);
    if (varies <= settings_.cycle_tolerance_mm) continue;
    refuse("compensate-cycle",
           fmt::format("the correction varies by {} mm along this hole, and a cycle that works the spindle can only "
                       "be shifted as a whole",
                       varies < kShownInFull ? fmt::format("{:.2g}", varies) : fmt::format("{:.4f}", varies)),
           "allow more with --cycle-tolerance, or drill a shorter hole", place_of(step_of(hole)));
  }
}

// The rapids over the hole and down to it, where they are part of its block, and those beside it.
void HoleCorrector::check_way_to(const CorrectedHole& hole) const {
  const nc::Step& step = step_of(hole);
  const MovePath& path = hole.at->move.path;
  for (std::size_t i = 0; i < step.motions.size(); ++i) {
    const nc::Motion& motion = step.motions[i];
    if (i >= way_to_hole(step) && !goes_beside(motion, step)) continue;
    if (!motion.known_before.contains(path.writable())) continue;
    const AxisWords commanded = step.frame->to_pose(motion.to + hole.shift);
    refuse_violations(check_way(corrector_, limits_, path.at_rest(motion.from), path.at_rest(motion.to), commanded),
                      step);
  }
}

// A cycle of an OSP is read for a tool that stands where it goes back to: on R, which is shifted with the hole (M54),
// or on the level of G71, which is not (M53). One of a Fanuc that begins on R, or on the bottom, goes back there. The
// correction may have shifted the tool otherwise.
void HoleCorrector::check_level(const CorrectedHole& corrected) const {
  const nc::Step& step = step_of(corrected);
  const nc::Hole& hole = step.holes.front();
  const bool levels = dialect_.behaviour.return_levels;
  const bool goes_to_start = !levels && dialect_.behaviour.fanuc_cycles && !step.after->retract_to_r;
  const bool on_bottom = goes_to_start && hole.clear == hole.bottom;
  if (!levels && !(goes_to_start && hole.clear == hole.r) && !on_bottom) return;
  const Axis normal = nc::axes_of(step.after->plane).third;
  const bool to_r = goes_to_start || step.after->retract_to_r || hole.clear == hole.r;
  const double r = hole.r + corrected.shift[normal];
  const double level = on_bottom ? hole.bottom + corrected.shift[normal] : to_r ? r : hole.clear;
  const double stands = stands_at_ + corrected.at->standing[normal];
  if (levels && !step.after->retract_to_r && hole.clear == hole.r && r > hole.clear) {
    refuse(
        "compensate-cycle",
        fmt::format("the correction lifts R to {0}{1:.6g}, above the level of G71, {0}{2:.6g}, which is not corrected",
                    letter(normal), r, hole.clear),
        "state a level above R with G71, 1 mm is enough, or go back to R with M54", place_of(step));
  }
  if (std::abs(stands - level) < (goes_to_start ? kStandsOnR : nc::kSameLevel) && (on_bottom || r <= level)) return;
  const double original = to_r ? hole.r : hole.clear;
  if (!goes_to_start && std::abs(stands_at_ - original) >= nc::kSameLevel) {
    refuse("compensate-cycle",
           fmt::format("the tool stands at {0}{1:.6g} and not on {2}, {0}{3:.6g}: how it comes from there to a hole "
                       "that the correction moves was found in no source",
                       letter(normal), stands_at_, to_r ? "R" : "the level of G71", original),
           fmt::format("move to {}{:.6g} with G0 before the cycle", letter(normal), original), place_of(step));
  }
  refuse("compensate-cycle",
         fmt::format("the correction puts the tool {:.3f} mm off {}, on which it stands in the original: how it comes "
                     "to the hole and back from there was found in no source",
                     stands - level,
                     on_bottom ? "the bottom of the hole"
                     : to_r    ? "R"
                               : "the level of G71"),
         goes_to_start ? "move the tool above R before the cycle, or write G99"
         : to_r        ? "state all six axes before the cycle, so that the move to above the hole is corrected as well"
                       : "drill the hole with moves (G0, G1), or where the correction is smaller",
         place_of(step));
}

}  // namespace plumbline::compensate
