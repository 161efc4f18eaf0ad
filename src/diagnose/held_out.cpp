#include "diagnose/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/evidence/linear_problem.hpp"
#include "diagnose/readings/poses.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double kLeastKept = 1e-6;  // share of a column: the only pose to show it costs much, and not infinitely much

}  // namespace

std::vector<bool> held_out(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                           const CandidateSet& candidates, const HeldOutOptions& options) {
  const std::vector<int> poses = poses_of(runs);
  const int count = *std::max_element(poses.begin(), poses.end()) + 1;
  std::vector<bool> out(runs.size(), false);
  if (count < options.least_poses) return out;

  identify::NoiseModel noise;
  for (std::size_t c = 0; c < noise.channels.size(); ++c) {
    noise.channels[c].sigma = c == identify::kRadial ? options.usual_radial : options.usual_torque;
  }
  const std::vector<Eigen::VectorXd> squares =
      column_squares(order, runs, candidates, candidates.unknowns.start(), noise);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(squares.front().size());
  for (const Eigen::VectorXd& run : squares) all += run;
  std::vector<double> cost(static_cast<std::size_t>(count), 0);
  for (int pose = 0; pose < count; ++pose) {
    Eigen::VectorXd own = Eigen::VectorXd::Zero(all.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (poses[i] == pose) own += squares[i];
    }
    for (Eigen::Index c = 0; c < static_cast<Eigen::Index>(candidates.columns.size()); ++c) {
      if (all[c] > 0) cost[static_cast<std::size_t>(pose)] -= std::log(std::max(1 - own[c] / all[c], kLeastKept));
    }
  }
  for (int k = 0; k < std::max(1, count / options.poses_of); ++k) {
    const auto cheapest = std::min_element(cost.begin(), cost.end());
    const int pose = static_cast<int>(cheapest - cost.begin());
    *cheapest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < runs.size(); ++i) out[i] = out[i] || poses[i] == pose;
  }
  return out;
}

}  // namespace plumbline::diagnose
