#include "measure/fine_waves.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::measure;

namespace {

constexpr int kWide = 1440;
const std::vector<std::size_t> kChoice{360, 540, 720, 1080, 1440};

double phi(Eigen::Index i) { return 2 * std::numbers::pi * static_cast<double>(i) / kWide; }

// Noise that remembers, and steps of the same place and size in all runs.
Eigen::MatrixXd noise_and_steps(Eigen::Index runs, double step) {
  testing::Random random(11);
  std::normal_distribution<double> normal(0, 0.1);
  Eigen::MatrixXd readings(runs, kWide);
  for (Eigen::Index r = 0; r < runs; ++r) {
    double now = 0;
    for (Eigen::Index i = 0; i < kWide; ++i) {
      now = 0.8 * now + normal(random);
      readings(r, i) = now + step * std::copysign(1.0, std::sin(phi(i) + 0.7)) + 20 * std::cos(2 * phi(i));
    }
  }
  return readings;
}

}  // namespace

TEST_CASE("neither noise of any colour nor steps at reversals are waves") {
  CHECK(fine_waves(noise_and_steps(6, 0), {0, 0, 0, 3, 3, 5}, 1e-3).empty());
  CHECK(fine_waves(noise_and_steps(6, 4), {0, 0, 0, 3, 3, 5}, 1e-3).empty());
}

TEST_CASE("a wave that comes again is found, and the grid holds it") {
  Eigen::MatrixXd readings = noise_and_steps(4, 1);
  for (Eigen::Index i = 0; i < kWide; ++i) readings.col(i).array() += 0.1 * std::cos(300 * phi(i) + 1);
  const std::vector<OrderRange> waves = fine_waves(readings, {0, 0, 0, 0}, 1e-3);
  REQUIRE(waves.size() == 1);
  CHECK(waves[0].lowest <= 300);
  CHECK(waves[0].highest >= 300);
  CHECK(points_for(waves, kChoice) == 1080);
  CHECK(fine_waves(readings, {0, 1, 2, 3}, 1e-3).empty());  // alone on their circles: nothing is said
}

TEST_CASE("the fewest points that hold all waves; else the most into which nothing folds") {
  CHECK(points_for({}, kChoice) == 360);
  CHECK(points_for({{0, 45}}, kChoice) == 360);
  CHECK(points_for({{100, 121}}, kChoice) == 540);
  CHECK(points_for({{100, 480}}, kChoice) == 1440);
  CHECK(points_for({{500, 600}}, kChoice) == 720);    // gone on 720 points, folded on 1440
  CHECK(points_for({{970, 1000}}, kChoice) == 1440);  // gone there as well
}
