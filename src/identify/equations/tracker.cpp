#include "identify/equations/tracker.hpp"

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/units.hpp"

namespace plumbline::identify {

SimulatedPoses simulate_poses(const machine::RotationOrder& order, const physics::ForceModel& forces,
                              const Tracked& tracked, const Sensitivity* sensitivity) {
  SimulatedPoses simulated;
  Slopes slopes;
  if (sensitivity != nullptr) {
    slopes.resize(kOutcomes, sensitivity->unknowns());
    simulated.slopes.resize(6 * static_cast<Eigen::Index>(tracked.table.poses.size()), sensitivity->unknowns());
  }
  physics::Environment at_rest = forces.environment();
  at_rest.friction = false;
  Eigen::Index row = 0;
  for (const measure::TrackedPose& pose : tracked.table.poses) {
    at_rest.payload_mass = pose.payload_mass;
    physics::Motion<double> motion;
    motion.pose = pose.commanded(order);
    const physics::TipError<double> error = physics::tip_error(forces, at_rest, motion);
    if (!error.converged()) {
      refuse("simulate-unreachable",
             fmt::format("the machine cannot stand at this pose: {}", physics::to_text(error.stopped_because)),
             "check the commanded columns of the table, and that it belongs to this machine", pose.place);
    }
    simulated.standing.push_back(error.pose);
    if (sensitivity == nullptr) continue;
    sensitivity->at(at_rest, motion, error, slopes);
    simulated.slopes.middleRows<3>(row) = slopes.middleRows<3>(kTipRow);
    simulated.slopes.middleRows<3>(row + 3) = slopes.middleRows<3>(kTurnRow);
    row += 6;
  }
  return simulated;
}

RunEquations tracker_equations(const machine::RotationOrder& order, const Tracked& tracked,
                               const SimulatedPoses& simulated, const TrackerFrame& frame, bool sloped) {
  const std::vector<measure::TrackedPose>& poses = tracked.table.poses;
  const bool tilt = tracked.table.has_tilt();
  RunEquations equations;
  equations.channels = tilt ? std::vector<int>{kTracker, kTrackerTilt} : std::vector<int>{kTracker};
  equations.samples = 3 * static_cast<Eigen::Index>(poses.size());
  const Eigen::Index rows = equations.samples * (tilt ? 2 : 1);
  equations.residual.resize(rows);
  if (!tracked.frame_known) equations.setup_slopes.setZero(rows, kFrame);
  sloped = sloped && simulated.slopes.size() > 0;
  if (sloped) equations.slopes.resize(rows, simulated.slopes.cols());

  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
    const Eigen::Index turned = equations.samples + at;
    const Pose<double>& standing = simulated.standing[i];
    // seen: R p + t, turned by R; a small turn w of the frame moves what is seen by w x (R p + t)
    const Vector3<double> seen = frame.R * standing.p_WT + frame.t;
    equations.residual.segment<3>(at) = poses[i].measured - seen;
    if (sloped) equations.slopes.middleRows<3>(at) = frame.R * simulated.slopes.middleRows<3>(2 * at);
    if (!tracked.frame_known) {
      equations.setup_slopes.block<3, 3>(at, 0).setIdentity();
      equations.setup_slopes.block<3, 3>(at, 3) = -machine::skew<double>(seen);
    }
    if (!tilt) continue;
    const Matrix3<double> R_seen = frame.R * standing.R_WP;
    const Matrix3<double> R_measured = machine::rotation<double>(order, *poses[i].measured_tilt);
    equations.residual.segment<3>(turned) = machine::logarithm<double>(R_measured * R_seen.transpose());
    if (sloped) equations.slopes.middleRows<3>(turned) = frame.R * simulated.slopes.middleRows<3>(2 * at + 3);
    if (!tracked.frame_known) equations.setup_slopes.block<3, 3>(turned, 3).setIdentity();
  }
  return equations;
}

TrackerFrame first_frame(const Tracked& tracked, double most) {
  const std::vector<measure::TrackedPose>& poses = tracked.table.poses;
  const auto count = static_cast<Eigen::Index>(poses.size());
  Eigen::Matrix3Xd commanded(3, count);
  Eigen::Matrix3Xd seen(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    commanded.col(i) = poses[static_cast<std::size_t>(i)].position_W;
    seen.col(i) = poses[static_cast<std::size_t>(i)].measured;
  }
  TrackerFrame frame;
  if (!tracked.frame_known) {
    const Eigen::Matrix4d rigid = Eigen::umeyama(commanded, seen, false);
    frame = {rigid.topLeftCorner<3, 3>(), rigid.topRightCorner<3, 1>()};
  }
  Eigen::Index worst = 0;
  const double off = (((frame.R * commanded).colwise() + frame.t) - seen).colwise().norm().maxCoeff(&worst);
  if (off > most) {
    refuse("tracker-far",
           fmt::format("this pose was measured {:.3g} mm from where the machine was sent, further than any other",
                       off / kMm),
           tracked.frame_known ? "the tracker does not measure in the frame W of the machine: leave --frame-known out"
                               : "check that rows belong together, the units (mm, deg), and that the tracker's frame "
                                 "is right-handed",
           poses[static_cast<std::size_t>(worst)].place);
  }
  return frame;
}

void move_frame(TrackerFrame& frame, const Eigen::VectorXd& step) {
  const Matrix3<double> turn = machine::exponential<double>(Vector3<double>(step.tail<3>()));
  frame.R = turn * frame.R;
  frame.t = turn * frame.t + step.head<3>();
}

}  // namespace plumbline::identify
