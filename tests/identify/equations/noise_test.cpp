#include "identify/equations/noise.hpp"

#include <random>

#include <catch2/catch.hpp>

#include "identify/equations/whitening.hpp"

using namespace plumbline;
using namespace plumbline::identify;

namespace {

// Runs of bar readings that hold noise alone, each with the columns of a set-up.
std::vector<RunEquations> noisy_runs(double sigma, double memory, std::size_t runs, Eigen::Index samples,
                                     std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<RunEquations> all;
  for (std::size_t r = 0; r < runs; ++r) {
    RunEquations run;
    run.channels = {kRadial};
    run.samples = samples;
    run.residual.resize(samples);
    run.setup_slopes.resize(samples, kSetup);
    double now = sigma * normal(random);
    for (Eigen::Index i = 0; i < samples; ++i) {
      const double angle = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(samples);
      run.residual[i] = now;
      run.setup_slopes.row(i) << -std::cos(angle), -std::sin(angle), -1;
      now = memory * now + std::sqrt(1 - memory * memory) * sigma * normal(random);
    }
    all.push_back(std::move(run));
  }
  return all;
}

// What a fit of the set-up leaves.
void fit_setups(std::vector<RunEquations>& runs) {
  for (RunEquations& run : runs) {
    run.residual -= run.setup_slopes * run.setup_slopes.colPivHouseholderQr().solve(run.residual);
  }
}

}  // namespace

TEST_CASE("sigma and memory of noise are found, although set-ups were fitted to it") {
  std::mt19937_64 random(41);
  for (const double memory : {0.0, 0.6, 0.9}) {
    INFO("memory " << memory);
    std::vector<RunEquations> runs = noisy_runs(0.5e-6, memory, 40, 120, random);
    fit_setups(runs);
    const ChannelNoise found = estimate_noise(runs).channels[kRadial];
    CHECK(found.samples == 4800);
    CHECK(found.memory == Approx(memory).margin(0.03));
    // the level at low frequencies is what standard errors live by
    const double level = std::sqrt(low_frequency_variance(found));
    CHECK(level == Approx(0.5e-6 * std::sqrt((1 + memory) / (1 - memory))).epsilon(0.1));
  }
}

TEST_CASE("a part of the noise that does not remember is told from the part that does") {
  std::mt19937_64 random(44);
  std::vector<RunEquations> runs = noisy_runs(0.4e-6, 0.9, 40, 120, random);
  std::normal_distribution<double> white(0, 0.3e-6);
  for (RunEquations& run : runs) {
    for (double& e : run.residual) e += white(random);
  }
  fit_setups(runs);
  const ChannelNoise found = estimate_noise(runs).channels[kRadial];
  CHECK(found.sigma == Approx(0.5e-6).epsilon(0.1));
  CHECK(found.memory == Approx(0.9).margin(0.04));
  CHECK(found.white == Approx(0.36).margin(0.08));
  const double level = 0.16 * 19 + 0.09;
  CHECK(low_frequency_variance(found) * 1e12 == Approx(level).epsilon(0.35));
}

TEST_CASE("unknowns that were fitted at low frequencies do not make noise forget") {
  std::mt19937_64 random(45);
  constexpr int kRuns = 30;
  constexpr double kMemory = 0.8;
  std::vector<RunEquations> runs = noisy_runs(0.5e-6, kMemory, kRuns, 120, random);
  FittedUnknowns fitted;
  fitted.scales = Eigen::VectorXd::Constant(2 * kRuns, 1e-6);
  fitted.precision = Eigen::MatrixXd::Zero(2 * kRuns, 2 * kRuns);
  for (int r = 0; r < kRuns; ++r) {  // the second harmonic of each run is unknown
    RunEquations& run = runs[static_cast<std::size_t>(r)];
    run.slopes = SlopeRows::Zero(run.samples, 2 * kRuns);
    for (Eigen::Index i = 0; i < run.samples; ++i) {
      const double angle = 4 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(run.samples);
      run.slopes.row(i).segment<2>(2 * r) << std::cos(angle), std::sin(angle);
    }
    Eigen::MatrixXd both(run.samples, kSetup + 2);
    both << run.setup_slopes, run.slopes.middleCols<2>(2 * r);
    run.residual -= both * both.colPivHouseholderQr().solve(run.residual);
  }
  const double careless = estimate_noise(runs).channels[kRadial].memory;
  fitted.noise.channels[kRadial] = {0.5e-6, kMemory, 120};
  for (RunEquations run : runs) {
    whiten(fitted.noise, run);
    const SlopeRows slopes = run.slopes * fitted.scales.asDiagonal();
    fitted.precision += slopes.transpose() * slopes;
  }
  const ChannelNoise found = estimate_noise(runs, {}, &fitted).channels[kRadial];
  CHECK(careless < kMemory - 0.05);
  CHECK(found.memory == Approx(kMemory).margin(0.03));
  CHECK(found.sigma == Approx(0.5e-6).epsilon(0.05));
}

TEST_CASE("a few gross outliers do not make the noise large") {
  std::mt19937_64 random(42);
  std::vector<RunEquations> runs = noisy_runs(0.5e-6, 0.5, 20, 120, random);
  for (RunEquations& run : runs) run.residual[17] += 300e-6;
  const ChannelNoise found = estimate_noise(runs).channels[kRadial];
  CHECK(found.sigma == Approx(0.5e-6).epsilon(0.15));
}

TEST_CASE("a channel that was not measured has no noise to estimate, and exact data the least") {
  std::mt19937_64 random(43);
  const NoiseModel noise = estimate_noise(noisy_runs(1e-15, 0, 3, 60, random), {.least_sigma_um = 0.01});
  CHECK(noise.channels[1].samples == 0);
  CHECK(noise.channels[kRadial].sigma == Approx(0.01e-6));
}
