#include "identify/equations/run_model.hpp"

#include <algorithm>
#include <array>

#include "measure/simulation.hpp"

namespace plumbline::identify {
namespace {

using machine::kStruts;

physics::TipError<double> standing(const physics::ForceModel& forces, const physics::Environment& environment,
                                   const physics::Motion<double>& motion, const measure::Run& run, std::size_t sample) {
  physics::TipError<double> error = physics::tip_error(forces, environment, motion);
  if (!error.converged()) measure::refuse_unreachable(run, sample, error.stopped_because);
  return error;
}

}  // namespace

std::string_view channel_name(int channel) {
  constexpr std::array<std::string_view, kAllChannels> kNames{"radial",  "torque1", "torque2", "torque3",     "torque4",
                                                              "torque5", "torque6", "tracker", "tracker_tilt"};
  return kNames.at(static_cast<std::size_t>(channel));
}

std::optional<Eigen::Index> RunEquations::first_row(int channel) const {
  const auto place = std::find(channels.begin(), channels.end(), channel);
  if (place == channels.end()) return std::nullopt;
  return (place - channels.begin()) * samples;
}

SimulatedRun simulate_run(const machine::RotationOrder& order, const physics::ForceModel& forces,
                          const measure::Run& run, const Sensitivity* sensitivity) {
  const physics::Environment environment = measure::environment_of(forces, run);
  const auto samples = static_cast<Eigen::Index>(run.samples());
  SimulatedRun simulated;
  simulated.tip_W.resize(3, samples);
  simulated.torque.resize(6, samples);
  Slopes slopes;
  if (sensitivity != nullptr) {
    slopes.resize(kOutcomes, sensitivity->unknowns());
    simulated.slopes.resize(kReadRows * samples, sensitivity->unknowns());
  }
  for (Eigen::Index i = 0; i < samples; ++i) {
    const auto sample = static_cast<std::size_t>(i);
    const physics::Motion<double> motion = measure::circular_motion(order, run, sample);
    const physics::TipError<double> error = standing(forces, environment, motion, run, sample);
    simulated.tip_W.col(i) = error.pose.p_WT;
    simulated.furthest_off = std::max(simulated.furthest_off, (error.pose.p_WT - motion.pose.p_WT).norm());
    simulated.torque.col(i) = error.loads.torque;
    if (sensitivity == nullptr) continue;
    sensitivity->at(environment, motion, error, slopes);
    for (int row = 0; row < kReadRows; ++row) simulated.slopes.row(row * samples + i) = slopes.row(row);
  }
  return simulated;
}

RunEquations run_equations(const measure::Run& run, const SimulatedRun& simulated, const measure::Setup& setup,
                           bool sloped) {
  RunEquations equations;
  equations.samples = simulated.tip_W.cols();
  const Eigen::Index n = equations.samples;
  if (run.has_radial()) equations.channels.push_back(kRadial);
  for (int j = 0; run.has_torque() && j < kStruts; ++j) equations.channels.push_back(1 + j);
  equations.residual.resize(n * static_cast<Eigen::Index>(equations.channels.size()));
  sloped = sloped && simulated.slopes.size() > 0;
  if (sloped) equations.slopes.resize(equations.residual.size(), simulated.slopes.cols());

  Eigen::Index row = 0;
  if (run.has_radial()) {
    // reading |tip - ball| - bar: a tip that moves by d reads e.d more, e from the ball to the tip
    const Eigen::Matrix3Xd from_ball = simulated.tip_W.colwise() - setup.ball_W;
    const Eigen::RowVectorXd distance = from_ball.colwise().norm();
    const Eigen::Matrix3Xd e = from_ball.array().rowwise() / distance.array();
    const Eigen::Map<const Eigen::VectorXd> measured(run.radial.data(), n);
    equations.residual.head(n) = measured.array() - (distance.transpose().array() - setup.bar);
    equations.setup_slopes.resize(n, kSetup);
    equations.setup_slopes.leftCols<2>() = -e.topRows<2>().transpose();
    equations.setup_slopes.col(2).setConstant(-1);
    if (sloped) {
      for (Eigen::Index i = 0; i < n; ++i) {
        equations.slopes.row(i) = e(0, i) * simulated.slopes.row(i) + e(1, i) * simulated.slopes.row(n + i) +
                                  e(2, i) * simulated.slopes.row(2 * n + i);
      }
    }
    row = n;
  }
  if (!run.has_torque()) return equations;
  for (int j = 0; j < kStruts; ++j, row += n) {
    const Eigen::Map<const Eigen::VectorXd> measured(run.torque[static_cast<std::size_t>(j)].data(), n);
    equations.residual.segment(row, n) = measured - simulated.torque.row(j).transpose();
  }
  if (sloped) equations.slopes.bottomRows(kStruts * n) = simulated.slopes.bottomRows(kStruts * n);
  return equations;
}

measure::Setup ideal_setup(const measure::Run& run) { return {measure::ideal_ball(run), run.bar_length()}; }

void move_setup(measure::Setup& setup, const Eigen::VectorXd& step) {
  setup.ball_W.head<2>() += step.head<2>();
  setup.bar += step[2];
}

}  // namespace plumbline::identify
