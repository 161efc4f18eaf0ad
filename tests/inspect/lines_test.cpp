#include "inspect/lines.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

struct Shaken {
  std::vector<measure::Run> runs;
  std::vector<identify::RunEquations> left;
  identify::NoiseModel noise;

  // White noise of 0.5 um, and a floor that shakes at `hertz`, its phase another in each run.
  Shaken(double hertz, double amplitude, double direction, std::size_t fast) {
    Random random(3);
    std::normal_distribution<double> normal;
    for (std::size_t r = 0; r < 10; ++r) {
      measure::Run run =
          circle_run({0, 0, -1000}, {0, 0, 0}, r % 2 == 0 ? measure::Direction::ccw : measure::Direction::cw);
      if (r < fast) {
        run.feed *= 6;
        for (double& time : run.time) time /= 6;
      }
      const double phase = 10 * normal(random);
      identify::RunEquations equations;
      equations.channels = {identify::kRadial};
      equations.samples = static_cast<Eigen::Index>(run.samples());
      equations.residual.resize(equations.samples);
      for (std::size_t i = 0; i < run.samples(); ++i) {
        const double shaken = amplitude * std::cos(2 * std::numbers::pi * hertz * run.time[i] + phase);
        run.radial[i] = 0.5e-6 * normal(random) + shaken * std::cos(run.angle[i] - direction);
        equations.residual[static_cast<Eigen::Index>(i)] = run.radial[i];
      }
      runs.push_back(run);
      left.push_back(equations);
    }
    noise.channels[identify::kRadial].sigma = 0.5e-6;
    noise.channels[identify::kRadial].samples = 1200;
  }
  std::vector<inspect::Line> lines() const { return inspect::find_lines(runs, left, noise); }
};

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

TEST_CASE("noise has no lines") { CHECK(Shaken(0, 0, 0, 4).lines().empty()); }

TEST_CASE("a floor that shakes is one frequency in slow and fast runs, with its direction") {
  const double hertz = 4.9;
  const double direction = 0.5;
  const Shaken shaken(hertz, 1.5e-6, direction, 4);
  const std::vector<inspect::Line> lines = shaken.lines();
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].runs.size() + lines[1].runs.size() == 10);
  for (const inspect::Line& line : lines) {
    CHECK(line.along);
    CHECK(line.amplitude / kUm == Approx(1.5).margin(0.3));
    CHECK(std::abs(std::remainder(line.direction - direction, std::numbers::pi)) < 0.15);
  }
  const auto common = inspect::common_frequency(lines, shaken.runs, 200);
  REQUIRE(common);
  CHECK(*common == Approx(hertz).margin(0.05));
  // a product of two waves has a quarter of the square of its amplitude
  const double shaken_rms = std::sqrt(1.5e-6 * 1.5e-6 / 4 + 0.5e-6 * 0.5e-6);
  const std::vector<measure::Run> still = inspect::without_lines(shaken.runs, lines);
  for (std::size_t r = 0; r < still.size(); ++r) {
    CHECK(rms(shaken.runs[r].radial) == Approx(shaken_rms).margin(0.16e-6));  // three standard deviations of 72 samples
    CHECK(rms(still[r].radial) < 0.6e-6);
  }
}

TEST_CASE("what has as many periods a turn at every feed is no line in time") {
  Shaken shaken(0, 0, 0, 5);
  for (std::size_t r = 0; r < shaken.runs.size(); ++r) {
    for (std::size_t i = 0; i < shaken.runs[r].samples(); ++i) {
      const double phase = 30.4 * shaken.runs[r].turn() * shaken.runs[r].angle[i];
      shaken.left[r].residual[static_cast<Eigen::Index>(i)] += 2e-6 * std::cos(phase + static_cast<double>(r));
    }
  }
  CHECK(shaken.lines().empty());
}

TEST_CASE("waves of the circle are no lines in time, and are left where they are") {
  Shaken shaken(0, 0, 0, 0);
  for (std::size_t r = 0; r < shaken.runs.size(); ++r) {
    for (std::size_t i = 0; i < shaken.runs[r].samples(); ++i) {
      shaken.left[r].residual[static_cast<Eigen::Index>(i)] += 5e-6 * std::cos(4 * shaken.runs[r].angle[i]);
    }
  }
  CHECK(shaken.lines().empty());
}
