#include "diagnose/doubt.hpp"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;
using measure::Direction;
using measure::Run;

constexpr double kSigma = 1e-6;

// Circles at twelve poses, there and back.
std::vector<Run> there_and_back() {
  std::vector<Run> runs;
  for (int pose = 0; pose < 12; ++pose) {
    const Vector3<double> centre{10.0 * pose, 100, -1008};
    runs.push_back(testing::circle_run(centre, {0, 0, 0}, Direction::ccw, 120));
    runs.push_back(testing::circle_run(centre, {0, 0, 0}, Direction::cw, 120));
  }
  return runs;
}

// Readings of the bar that remember the one before, and two waves on top.
RunEquations noisy(const Run& run, std::mt19937_64& random, double memory, double wave, double size = kSigma) {
  std::normal_distribution<double> normal;
  RunEquations equations;
  equations.channels = {identify::kRadial};
  equations.samples = static_cast<Eigen::Index>(run.samples());
  equations.residual.resize(equations.samples);
  double e = normal(random);
  for (Eigen::Index i = 0; i < equations.samples; ++i) {
    e = memory * e + std::sqrt(1 - memory * memory) * normal(random);
    const double angle = run.angle[static_cast<std::size_t>(i)];
    equations.residual[i] = size * e + wave * (std::cos(2 * angle) + std::sin(3 * angle));
  }
  return equations;
}

std::optional<Recurring> recurring_with(unsigned seed, double memory, double wave_even, double wave_odd,
                                        double size = kSigma) {
  std::mt19937_64 random(seed);
  const std::vector<Run> runs = there_and_back();
  std::vector<RunEquations> residuals;
  for (const Run& run : runs) {
    const double sign = run.direction == Direction::ccw ? 1 : -1;
    residuals.push_back(noisy(run, random, memory, wave_even + sign * wave_odd, size));
  }
  return recurring(contrasts_of(runs, residuals), {}).radial;
}

}  // namespace

TEST_CASE("noise does not come again, however long it remembers") {
  int false_alarms = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    for (const double memory : {0.0, 0.7, 0.97}) false_alarms += recurring_with(seed, memory, 0, 0) ? 1 : 0;
  }
  CHECK(false_alarms == 0);
}

TEST_CASE("waves that two runs at one pose share are no noise, though smaller than it") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::optional<Recurring> even = recurring_with(seed, 0.7, 0.9 * kSigma, 0);
    REQUIRE(even);
    CHECK(even->by == Difference::direction);
    CHECK(even->correlation > 0.1);
    const std::optional<Recurring> odd = recurring_with(seed, 0.7, 0, 0.9 * kSigma);
    REQUIRE(odd);
    CHECK(odd->correlation < -0.1);
  }
}

TEST_CASE("what comes again in the last digit is rounding") {
  CHECK(recurring_with(1, 0, 5e-8, 0, 1e-9));
  CHECK_FALSE(recurring_with(1, 0, 5e-9, 0, 1e-9));
}

TEST_CASE("runs held out that are much further off than single runs are were not predicted") {
  std::mt19937_64 random(1);
  const std::vector<Run> runs = there_and_back();
  std::vector<bool> out(runs.size(), false);
  out[4] = out[5] = true;
  const auto times = [&](double size_out, double wobble) {
    std::vector<RunEquations> residuals;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double size = out[i] ? size_out : (i % 2 == 0 ? 1 + wobble : 1 - wobble);
      residuals.push_back(noisy(runs[i], random, 0, 0, size * kSigma));
    }
    return not_predicted(residuals, out, &ResidualSums::radial, {});
  };
  CHECK_FALSE(times(1.0, 0));
  CHECK_FALSE(times(1.2, 0));
  REQUIRE(times(2.0, 0));
  CHECK(*times(2.0, 0) == Approx(2).epsilon(0.2));
  CHECK_FALSE(times(1.5, 0.9));  // single runs differ as much
  std::vector<bool> none(runs.size(), false);
  std::vector<RunEquations> residuals;
  for (const Run& run : runs) residuals.push_back(noisy(run, random, 0, 0));
  CHECK_FALSE(not_predicted(residuals, none, &ResidualSums::radial, {}));
}

}  // namespace plumbline::diagnose
