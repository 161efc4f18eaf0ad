#include "diagnose/gap/channels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angle.hpp"

namespace plumbline::diagnose {

using identify::RunEquations;
using measure::Run;

std::optional<Eigen::VectorXd> channel_of(const RunEquations& run, int channel) {
  const std::optional<Eigen::Index> first = run.first_row(channel);
  if (!first) return std::nullopt;
  return run.residual.segment(*first, run.samples);
}

std::complex<double> wave_of(const Eigen::VectorXd& e, const std::vector<double>& angle, int order) {
  std::complex<double> sum = 0;
  for (Eigen::Index i = 0; i < e.size(); ++i) sum += e[i] * std::polar(1.0, order * angle[static_cast<std::size_t>(i)]);
  return sum / static_cast<double>(e.size());
}

ChannelResiduals around_the_circle(const std::vector<Run>& runs, const std::vector<RunEquations>& residuals,
                                   int channel, const identify::ChannelNoise& noise) {
  ChannelResiduals around{channel};
  MeanSquare all;
  std::array<MeanSquare, kArcs> arcs;
  std::array<MeanSquare, kWaves> waves;
  std::array<MeanSquare, kWaves> floors;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::optional<Eigen::VectorXd> e = channel_of(residuals[r], channel);
    if (!e) continue;
    for (Eigen::Index i = 0; i < e->size(); ++i) {
      const double share = within_turn(runs[r].angle[static_cast<std::size_t>(i)]) / kTurn;
      all.add((*e)[i]);
      arcs.at(std::min<std::size_t>(static_cast<std::size_t>(share * kArcs), kArcs - 1)).add((*e)[i]);
    }
    const auto n = static_cast<double>(e->size());
    for (int k = 0; k < kWaves; ++k) {
      const auto place = static_cast<std::size_t>(k);
      waves.at(place).add(std::numbers::sqrt2 * std::abs(wave_of(*e, runs[r].angle, k + 1)));
      floors.at(place).add(std::sqrt(2 / n * noise_power(noise, (k + 1) / n)));
    }
  }
  around.rms = all.root();
  for (std::size_t a = 0; a < kArcs; ++a) around.arcs.at(a) = arcs.at(a).root();
  for (std::size_t k = 0; k < kWaves; ++k) {
    around.waves.at(k) = waves.at(k).root();
    around.wave_noise.at(k) = floors.at(k).root();
  }
  return around;
}

}  // namespace plumbline::diagnose
