#include "diagnose/search/stage.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "diagnose/readings/noise_spectrum.hpp"

namespace plumbline::diagnose {
namespace {

using identify::ChannelNoise;
using identify::NoiseModel;

bool alike(const NoiseModel& a, const NoiseModel& b, const SearchOptions& options) {
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    const ChannelNoise& one = a.channels[c];
    const ChannelNoise& other = b.channels[c];
    if (one.samples != other.samples || std::abs(one.sigma - other.sigma) > options.size_alike * other.sigma ||
        std::abs(one.memory - other.memory) > options.colour_alike ||
        std::abs(one.white - other.white) > options.colour_alike) {
      return false;
    }
  }
  return true;
}

NoiseModel first_noise(const Workbench& bench, const NoiseModel& before) {
  const auto is_unknown = [](const ChannelNoise& channel) { return channel.samples == 0; };
  if (!std::all_of(before.channels.begin(), before.channels.end(), is_unknown)) return before;
  identify::Objective objective(bench.machine.rotation, bench.runs, identify::Unknowns(bench.forces), {.huber = 0});
  return identify::rough_noise(objective.equations(Eigen::VectorXd(0)));
}

std::string noise_text(const NoiseModel& noise) {
  const ChannelNoise& bar = noise.channels[identify::kRadial];
  const ChannelNoise& torque = noise.channels[identify::kRadial + 1];
  return fmt::format(
      "noise: bar {:.3f} um (memory {:.2f}, white {:.2f}), torque {:.4f} N m (memory {:.2f}, white {:.2f})",
      bar.sigma * 1e6, bar.memory, bar.white, torque.sigma, torque.memory, torque.white);
}

}  // namespace

FittedStage fitted_stage(const Workbench& bench, std::vector<Pick> picks, const Eigen::VectorXd& start,
                         const NoiseModel& noise, const SearchOptions& options, const Say& say) {
  FittedStage stage;
  stage.picks = std::move(picks);
  stage.noise = first_noise(bench, noise);
  Eigen::VectorXd from = start;
  for (int round = 0; round < options.most_noise_rounds; ++round) {
    stage.fit = refit(bench, stage.picks, from, stage.noise, options.refit);
    from = stage.fit.values;
    const NoiseModel next = noise_of(stage.fit.residuals);
    if (alike(next, stage.noise, options)) break;
    if (round + 1 < options.most_noise_rounds) stage.noise = next;
  }
  stage.problem =
      std::make_shared<LinearProblem>(linearise(bench.machine.rotation, bench.runs, bench.candidates, stage.fit.values,
                                                stage.noise, may_be_marginalised(bench.candidates, stage.picks)));
  say(noise_text(stage.noise));
  return stage;
}

}  // namespace plumbline::diagnose
