// What a model says of poses that a tracker measured, beside what it saw.
#pragma once

#include <vector>

#include "identify/equations/run_model.hpp"
#include "measure/tracker.hpp"

namespace plumbline::identify {

/// Unknowns of the tracker's set-up: where its frame lies, a shift and a turn.
inline constexpr int kFrame = 6;

/// Where the tracker's frame lies: it sees the point p of W at R p + t.
struct TrackerFrame {
  Matrix3<double> R = Matrix3<double>::Identity();
  Vector3<double> t = Vector3<double>::Zero();  // m
};

/// Measured poses as a fit takes them.
struct Tracked {
  measure::TrackedPoses table;
  bool frame_known = false;  // the tracker measures in W; else its frame is fitted
};

/// Where the machine stands when it is sent to each pose, at rest: without friction of the screws. Slopes have six rows
/// for each pose, tip x, y, z (m) and rotation (rad about the axes of W), pose after pose.
struct SimulatedPoses {
  std::vector<Pose<double>> standing;
  SlopeRows slopes;  // empty if not asked for
};

/// Refuses with simulate-unreachable.
SimulatedPoses simulate_poses(const machine::RotationOrder& order, const physics::ForceModel& forces,
                              const Tracked& tracked, const Sensitivity* sensitivity = nullptr);

/// The equations of all poses: channel kTracker (x, y, z of each pose, m), then kTrackerTilt (rad) if angles were
/// measured, in the tracker's frame. setup_slopes has all rows, by shift and turn of the frame (about its origin), and
/// is empty if the frame is known. Slopes of the unknowns as run_equations has them.
RunEquations tracker_equations(const machine::RotationOrder& order, const Tracked& tracked,
                               const SimulatedPoses& simulated, const TrackerFrame& frame, bool sloped = true);

/// The frame in which the measured positions lie nearest to the commanded ones [Kabsch 1976]; W if it is known. Refuses
/// with tracker-far if some pose is further off than `most` (m): rows or units are mixed up.
TrackerFrame first_frame(const Tracked& tracked, double most = 0.02);

/// Moves a frame by a step in the order of setup_slopes.
void move_frame(TrackerFrame& frame, const Eigen::VectorXd& step);

}  // namespace plumbline::identify
