#include "measure/thinning.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include "measure/runs.hpp"

using namespace plumbline;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Readings of a known wave on a turn, and white noise.
measure::Run long_run(std::size_t samples, measure::Direction direction, double sigma) {
  measure::Run run = testing::circle_run({0, 100, -1008}, {0, 0, 0}, direction, samples);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, sigma);
  run.radial.clear();
  for (const double angle : run.angle)
    run.radial.push_back(1e-5 * std::cos(3 * angle) + (sigma > 0 ? normal(random) : 0));
  for (auto& torque : run.torque) torque = run.angle;
  return run;
}

}  // namespace

TEST_CASE("a long record becomes means of consecutive samples, angles followed past a turn") {
  for (const auto direction : {measure::Direction::ccw, measure::Direction::cw}) {
    const measure::Thinned thinned = measure::thinned({long_run(50000, direction, 0)});
    const measure::Run& run = thinned.runs.front();
    CHECK(thinned.thinning.runs == 1);
    CHECK(thinned.thinning.thinned == 1);
    CHECK(thinned.thinning.largest == 138);
    CHECK(thinned.thinning.longest == 50000);
    CHECK(run.samples() == 363);
    CHECK(run.radial.size() == run.samples());
    CHECK(run.torque[5].size() == run.samples());
    CHECK(run.time.size() == run.samples());
    for (std::size_t i = 0; i < run.samples(); ++i) {
      CHECK(run.radial[i] == Approx(1e-5 * std::cos(3 * run.angle[i])).margin(1e-8));
      CHECK(run.angle[i] >= 0);
      CHECK(run.angle[i] < kTurn);
    }
  }
}

TEST_CASE("white noise of means is smaller by the root of their number") {
  const measure::Run run = measure::thinned({long_run(36000, measure::Direction::ccw, 1e-6)}).runs.front();
  double sum = 0;
  for (std::size_t i = 0; i < run.samples(); ++i) sum += std::pow(run.radial[i] - 1e-5 * std::cos(3 * run.angle[i]), 2);
  CHECK(std::sqrt(sum / static_cast<double>(run.samples())) == Approx(1e-7).epsilon(0.15));
}

TEST_CASE("records that are short enough stay as they are") {
  for (const std::size_t samples : {120, 360, 719}) {
    const measure::Run before = long_run(samples, measure::Direction::cw, 0);
    const measure::Thinned thinned = measure::thinned({before});
    CHECK(thinned.thinning.thinned == 0);
    CHECK(thinned.runs.front().angle == before.angle);
    CHECK(thinned.runs.front().radial == before.radial);
  }
}
