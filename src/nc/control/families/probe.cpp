// G38.2 to G38.5: a feed that ends where the probe touches, or lets go.
#include <cmath>

#include "nc/control/execution.hpp"
#include "nc/control/state/system_parameters.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr int kProbeResult = 5061;  // to #5066: where it touched
constexpr int kToContact = 382, kFromContact = 384;
constexpr double kBackOffMm = 0.254, kBackOffInch = 0.01;

// Where rs274, which has no probe, takes the tool to stand: a little before the end [measured].
AxisWords backed_off(const Execution& run, const Motion& motion) {
  AxisWords stands = motion.to;
  const AxisWords travel = motion.to - motion.from;
  const double length = std::hypot(travel[Axis::X], travel[Axis::Y], travel[Axis::Z]);
  if (length == 0) return stands;
  const double back = run.control.modal.inches ? kBackOffInch * run.control.length_unit() : kBackOffMm;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) stands[axis] -= back * travel[axis] / length;
  return stands;
}

}  // namespace

// What it finds only the machine knows. trace, which takes tables to be empty, goes on as rs274 does.
void move_probe(Execution& run) {
  Control& control = run.control;
  need_offsets(run);
  if (run.axes.empty()) {
    run.refuse(run.motion_code(), codes::kAxesMissing, "the probe is not told where to go", "add X, Y or Z");
  }
  if (control.modal.feed_mode == FeedMode::inverse_time) {
    run.refuse(run.motion_code(), codes::kFeedMissing, "a probe takes no inverse time (G93)", "write G94 before it");
  }
  if (control.modal.feed_mode == FeedMode::per_revolution) {  // [M]
    run.refuse(run.motion_code(), codes::kFeedMissing, "a probe takes no feed per revolution (G95)",
               "write G94 before it");
  }
  Motion motion;
  motion.kind = MotionKind::probe;
  motion.to = end_of_move(run);
  // G38.2 and G38.4, to which no contact is an error [M]
  const bool needs_contact = run.motion->code == kToContact || run.motion->code == kFromContact;
  if (needs_contact && motion.to == control.position && control.known.contains(run.axes)) {
    run.refuse(run.motion_code(), codes::kOutOfRange, "the probe stands already where this sends it",
               "send it beyond the place where it shall touch");
  }
  motion.known_after = known_after_move(run);
  motion.feed = feed_of_move(run, true);
  add_motion(run, motion);
  const bool known = run.settings.as_with_empty_tables;
  for (const Axis axis : kAllAxes) {
    const double unit = is_rotary(axis) ? 1 : control.length_unit();
    control.parameters.set(kProbeResult + static_cast<int>(index(axis)), {motion.to[axis] / unit, known});
  }
  control.parameters.set(kProbeSuccess, {0, known});
  if (known) control.position = backed_off(run, run.motions.back());
  lose_position(run, AxisSet::all());
}

}  // namespace plumbline::nc
