#include "diagnose/readings/noise_spectrum.hpp"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;

// Residuals of 20 runs of 120 samples, bar and motors: a white part and one that remembers.
std::vector<RunEquations> drawn(double radial, double torque, double memory, double white) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<RunEquations> runs(20);
  for (RunEquations& run : runs) {
    run.samples = 120;
    run.residual.resize(7 * 120);
    for (int channel = 0; channel < identify::kChannels; ++channel) {
      run.channels.push_back(channel);
      const double sigma = channel == identify::kRadial ? radial : torque;
      double remembered = std::sqrt(1 - white) * normal(random);
      for (Eigen::Index i = 0; i < 120; ++i) {
        run.residual[120 * channel + i] = sigma * (remembered + std::sqrt(white) * normal(random));
        remembered = memory * remembered + std::sqrt((1 - memory * memory) * (1 - white)) * normal(random);
      }
    }
  }
  return runs;
}

// What weighs slow changes: the square root of the spectrum at frequency nil.
double slow(const identify::ChannelNoise& noise) {
  return noise.sigma * std::sqrt((1 - noise.white) * (1 + noise.memory) / (1 - noise.memory) + noise.white);
}

TEST_CASE("size and colour of noise come out of its spectrum") {
  const identify::NoiseModel noise = noise_of(drawn(0.5e-6, 0.05, 0.7, 0.64));
  CHECK(noise.channels[0].sigma == Approx(0.5e-6).epsilon(0.05));
  CHECK(noise.channels[3].sigma == Approx(0.05).epsilon(0.05));
  CHECK(slow(noise.channels[3]) == Approx(0.05 * std::sqrt(0.36 * 1.7 / 0.3 + 0.64)).epsilon(0.12));
}

TEST_CASE("white noise is found white") {
  const identify::NoiseModel noise = noise_of(drawn(1e-6, 0.02, 0, 1));
  CHECK(noise.channels[0].sigma == Approx(1e-6).epsilon(0.05));
  CHECK(slow(noise.channels[2]) == Approx(0.02).epsilon(0.1));
}

TEST_CASE("what a model lacks in a few runs hardly counts as noise") {
  std::vector<RunEquations> runs = drawn(0.5e-6, 0.05, 0.7, 0.64);
  const double before = slow(noise_of(runs).channels[1]);
  for (int run = 0; run < 3; ++run) {
    for (Eigen::Index i = 0; i < 120; ++i) {
      runs[static_cast<std::size_t>(run)].residual[120 + i] += std::sin(0.1 * static_cast<double>(i));
    }
  }
  CHECK(slow(noise_of(runs).channels[1]) < 1.3 * before);
}

}  // namespace
}  // namespace plumbline::diagnose
