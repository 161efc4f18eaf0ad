// What a model says of a run, beside what was measured: residuals, and how readings move with the unknowns and the
// set-up.
#pragma once

#include <optional>
#include <vector>

#include "identify/equations/sensitivity.hpp"
#include "measure/setup.hpp"

namespace plumbline::identify {

/// What one sample reads: the bar, and six torques.
inline constexpr int kChannels = 7;
inline constexpr int kRadial = 0;
/// Rows of outcomes that runs read: the tip and the torques.
inline constexpr int kReadRows = kTurnRow;
/// Channels of a tracker, after those of runs: where the tip is (m), how the platform is turned (rad).
inline constexpr int kTracker = kChannels;
inline constexpr int kTrackerTilt = kChannels + 1;
inline constexpr int kAllChannels = kChannels + 2;
/// What the set-up of a run leaves open: the ball's x and y, the bar's length. On a circle the ball's height changes
/// all readings alike, as the bar's length does.
inline constexpr int kSetup = 3;
/// "radial", "torque1", ... as the columns of datasets are called; "tracker", "tracker_tilt".
std::string_view channel_name(int channel);

/// Rows of readings, columns of unknowns; a row is contiguous, as samples come one after the other.
using SlopeRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A run as a model makes it, the bar's set-up apart. Rows of `slopes` (for each unknown a column): tip x of all
/// samples, tip y, tip z, then the torques of strut 1, of strut 2, ...
struct SimulatedRun {
  Eigen::Matrix3Xd tip_W;                           // m
  double furthest_off = 0;                          // m, of the tip from where it is commanded, at the worst sample
  Eigen::Matrix<double, 6, Eigen::Dynamic> torque;  // N m
  SlopeRows slopes;                                 // empty if not asked for
};

/// Simulates a run by the fixed point of physics::tip_error; with `sensitivity`, which belongs to `forces`, the slopes,
/// too. Refuses with simulate-unreachable as measure::simulate_run does.
SimulatedRun simulate_run(const machine::RotationOrder& order, const physics::ForceModel& forces,
                          const measure::Run& run, const Sensitivity* sensitivity = nullptr);

/// The equations of a run for small changes of the unknowns and of the set-up:
///   residual = slopes d(unknowns) + setup_slopes d(setup) + noise
/// Rows: all samples of the first measured channel, then of the next one. SI.
struct RunEquations {
  std::vector<int> channels;     // those that were measured
  Eigen::Index samples = 0;      // of each channel
  Eigen::VectorXd residual;      // measured minus simulated
  SlopeRows slopes;              // of the simulated readings by the unknowns; empty if the run was simulated without
  Eigen::MatrixXd setup_slopes;  // of the first channels, those that a set-up moves: of a run samples x kSetup, of the
                                 // bar alone; empty if nothing that was measured has a set-up

  /// The first of the `samples` rows of a channel; nothing if it was not measured.
  std::optional<Eigen::Index> first_row(int channel) const;
};

/// Without the slopes of the unknowns if they were not simulated, or are not asked for by `sloped`.
RunEquations run_equations(const measure::Run& run, const SimulatedRun& simulated, const measure::Setup& setup,
                           bool sloped = true);

/// The ball where it ideally stands, the bar as long as stated.
measure::Setup ideal_setup(const measure::Run& run);

/// Moves a set-up by a step in the order of setup_slopes.
void move_setup(measure::Setup& setup, const Eigen::VectorXd& step);

}  // namespace plumbline::identify
