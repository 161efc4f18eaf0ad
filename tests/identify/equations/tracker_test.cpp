// Poses that a tracker measured: frame, angles, and a calibration from them.
#include "identify/equations/tracker.hpp"

#include <catch2/catch.hpp>

#include "identify/identify.hpp"
#include "identify/plans.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

// What a tracker somewhere in the hall sees of a machine with these forces, at poses all over its travel.
Tracked tracked_poses(const physics::ForceModel& forces, const TrackerFrame& frame, std::size_t count, double sigma,
                      double sigma_tilt, Random& random) {
  const machine::MachineModel machine = pm600_like();
  std::normal_distribution<double> normal;
  Tracked tracked;
  physics::Environment at_rest = forces.environment();
  at_rest.friction = false;
  while (tracked.table.poses.size() < count) {
    measure::TrackedPose pose;
    pose.position_W = {uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2), uniform(random, -1.2, -0.85)};
    pose.tilt = {uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3), uniform(random, -0.2, 0.2)};
    physics::Motion<double> motion;
    motion.pose = pose.commanded(machine.rotation);
    const Pose<double> standing = physics::tip_error(forces, at_rest, motion).pose;
    pose.measured = frame.R * standing.p_WT + frame.t;
    for (double& x : pose.measured) x += sigma * normal(random);
    if (sigma_tilt > 0) {
      const machine::Angles seen = machine::nearest_angles(machine.rotation, frame.R * standing.R_WP, pose.tilt);
      pose.measured_tilt = seen.abc;
      for (double& x : *pose.measured_tilt) x += sigma_tilt * normal(random);
    }
    tracked.table.poses.push_back(pose);
  }
  tracked.table.file = "tracker.csv";
  return tracked;
}

const TrackerFrame kHall{machine::exponential<double>({0.1, -0.2, 2.5}), {3.1, -2.2, 0.7}};

bool shifts_base_along_x(const WholeMotion& motion) {
  return motion.kind == WholeMotion::Kind::shift && motion.ring == WholeMotion::Ring::base && motion.axis == 0;
}
bool widens_platform(const WholeMotion& motion) {
  return motion.kind == WholeMotion::Kind::wider_ring && motion.ring == WholeMotion::Ring::platform;
}

}  // namespace

TEST_CASE("the frame of a tracker is found, and poses that were not measured where the machine went are refused") {
  Random random(81);
  Tracked tracked = tracked_poses(physics::ForceModel(pm600_like()), kHall, 20, 0, 0, random);
  const TrackerFrame frame = first_frame(tracked);
  CHECK((frame.R - kHall.R).cwiseAbs().maxCoeff() < 1e-3);
  CHECK((frame.t - kHall.t).cwiseAbs().maxCoeff() < 1e-3);
  for (std::size_t i = 0; i < tracked.table.poses.size(); ++i) tracked.table.poses[i].place = {"tracker.csv", i + 2};
  std::swap(tracked.table.poses[3].measured, tracked.table.poses[4].measured);
  const Diagnostic refused = refusal_of([&] { first_frame(tracked); });
  CHECK(refused.code == "tracker-far");
  CHECK((refused.place.line == 5 || refused.place.line == 6));
  tracked.frame_known = true;
  CHECK(refusal_of([&] { first_frame(tracked); }).code == "tracker-far");
}

TEST_CASE("the tracker's equations hold for small changes of the frame and of the unknowns") {
  Random random(82);
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  const Tracked tracked = tracked_poses(unknowns.forces(), kHall, 5, 10e-6, 10e-6, random);
  const Sensitivity sensitivity(unknowns.forces(), unknowns);
  const SimulatedPoses poses = simulate_poses(machine.rotation, unknowns.forces(), tracked, &sensitivity);
  const RunEquations here = tracker_equations(machine.rotation, tracked, poses, kHall);
  REQUIRE(here.channels == std::vector<int>{kTracker, kTrackerTilt});
  REQUIRE(here.residual.size() == 30);

  Eigen::VectorXd step(kFrame);
  step << 1e-6, -2e-6, 3e-6, 2e-6, 1e-6, -1e-6;
  TrackerFrame moved = kHall;
  move_frame(moved, step);
  const RunEquations there = tracker_equations(machine.rotation, tracked, poses, moved);
  CHECK((there.residual - (here.residual - here.setup_slopes * step)).cwiseAbs().maxCoeff() < 1e-10);

  const Eigen::VectorXd change = 0.02 * (drawn(unknowns, random) - unknowns.start());
  const physics::ForceModel other = unknowns.at(unknowns.start() + change);
  const RunEquations after =
      tracker_equations(machine.rotation, tracked, simulate_poses(machine.rotation, other, tracked), kHall);
  CHECK((after.residual - (here.residual - here.slopes * change)).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((here.slopes * change).cwiseAbs().maxCoeff() > 2e-7);
}

TEST_CASE("a machine is calibrated from a tracker's poses, wherever the tracker stood") {
  Random random(83);
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  const Unknowns unknowns = geometry_unknowns(machine, forces);
  const Eigen::VectorXd truth = drawn(unknowns, random);
  for (const double sigma_tilt : {0.0, 3e-6}) {
    INFO("angles " << sigma_tilt);
    const Tracked tracked = tracked_poses(unknowns.at(truth), kHall, 80, 2e-6, sigma_tilt, random);
    const Identification found = identify::identify(machine, {}, {.stages = Stages::geometry}, &tracked);
    REQUIRE(found.converged());
    const Fit& fit = found.stages[0].fit;
    const Eigen::VectorXd off = fit.values - truth;
    CHECK(off.dot(fit.covariance.ldlt().solve(off)) == Approx(static_cast<double>(off.size())).epsilon(0.6));
    // what the unknowns take is shared by positions and angles by their number, though angles tell more: 5 % too much
    CHECK(fit.noise.channels[kTracker].sigma == Approx(2e-6).epsilon(0.2));
    if (sigma_tilt > 0) CHECK(fit.noise.channels[kTrackerTilt].sigma == Approx(sigma_tilt).epsilon(0.15));
    CHECK(found.after.tracker_rms < 0.5 * found.before.tracker_rms);
    CHECK(found.after.radial_readings == 0);
    // where the tracker stands is not known, so a shift of the base is nothing that it sees
    for (const WholeMotion& motion : whole_motions(machine.geometry, fit.unknowns)) {
      INFO(static_cast<int>(motion.kind) << " about " << motion.axis);
      const double left = left_of_prior(motion, fit.unknowns, fit.covariance);
      if (shifts_base_along_x(motion)) CHECK(left > 0.9);
      if (widens_platform(motion)) CHECK(left < 0.9);
    }
  }
}

TEST_CASE("a tracker that measures in the machine's frame sees where the base is") {
  Random random(84);
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = geometry_unknowns(machine, physics::ForceModel(machine));
  Tracked tracked = tracked_poses(unknowns.forces(), {}, 80, 1e-6, 0, random);
  tracked.frame_known = true;
  const Identification found = identify::identify(machine, {}, {.stages = Stages::geometry}, &tracked);
  REQUIRE(found.converged());
  const Fit& fit = found.stages[0].fit;
  for (const WholeMotion& motion : whole_motions(machine.geometry, fit.unknowns)) {
    if (!shifts_base_along_x(motion)) continue;
    CHECK(left_of_prior(motion, fit.unknowns, fit.covariance) < 0.85);
  }
}
