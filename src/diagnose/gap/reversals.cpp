#include "diagnose/gap/reversals.hpp"

#include <cmath>

#include "measure/circularity.hpp"

namespace plumbline::diagnose {

namespace {

using identify::kRadial;
using identify::RunEquations;
using measure::Run;

// A step and how readings would move with it: step = slope x size + noise.
struct Step {
  double slope, step;
};

// Size and standard error by least squares.
std::pair<double, double> size_of(const std::vector<Step>& steps) {
  double cross = 0;
  double square = 0;
  for (const Step& s : steps) {
    cross += s.slope * s.step;
    square += s.slope * s.slope;
  }
  if (steps.size() < 3 || !(square > 0)) return {0, 0};
  const double size = cross / square;
  double squares = 0;
  for (const Step& s : steps) squares += std::pow(s.step - s.slope * size, 2);
  return {size, std::sqrt(squares / static_cast<double>(steps.size() - 1) / square)};
}

// dx = J^-1 dL: how the bar moves with the length of a strut
double bar_by_length(const SampleState& state, const Vector3<double>& ball, int strut) {
  machine::Vector6<double> length = machine::Vector6<double>::Zero();
  length[strut] = 1;
  const machine::Vector6<double> moved = machine::Lu6<double>(machine::jacobian(state.struts)).solve(length);
  return (state.pose.p_WT - ball).normalized().dot(moved.head<3>());
}

}  // namespace

std::vector<Reversal> reversals_of(const std::vector<Run>& runs, const std::vector<std::vector<SampleState>>& states,
                                   const std::vector<RunEquations>& residuals, const ReversalOptions& options) {
  std::vector<Reversal> all;
  for (int j = 0; j < machine::kStruts; ++j) {
    Reversal reversal{j};
    std::vector<Step> lengths;
    std::vector<Step> torques;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::optional<Eigen::VectorXd> radial = channel_of(residuals[r], kRadial);
      const std::optional<Eigen::VectorXd> torque = channel_of(residuals[r], 1 + j);
      const Eigen::Map<const Eigen::VectorXd> angle(runs[r].angle.data(),
                                                    static_cast<Eigen::Index>(runs[r].angle.size()));
      for (std::size_t s = 0; s + 1 < states[r].size(); ++s) {
        const double before = states[r][s].speed[j];
        const double after = states[r][s + 1].speed[j];
        if ((before < 0) == (after < 0)) continue;
        ++reversal.count;
        const double there =
            angle[static_cast<Eigen::Index>(s)] +
            before / (before - after) * (angle[static_cast<Eigen::Index>(s + 1)] - angle[static_cast<Eigen::Index>(s)]);
        // a step towards greater angles, as one towards greater speed
        const double sign = runs[r].turn() * (after > before ? 1 : -1);
        const auto add = [&](const std::optional<Eigen::VectorXd>& e, double slope, std::vector<Step>& steps) {
          if (!e) return;
          const auto step = measure::reversal_step({angle, *e}, there, options.window);
          if (step) steps.push_back({slope, sign * *step});
        };
        add(radial, bar_by_length(states[r][s], measure::ideal_ball(runs[r]), j), lengths);
        add(torque, 1, torques);
      }
    }
    std::tie(reversal.length, reversal.length_error) = size_of(lengths);
    std::tie(reversal.torque, reversal.torque_error) = size_of(torques);
    all.push_back(reversal);
  }
  return all;
}

}  // namespace plumbline::diagnose
