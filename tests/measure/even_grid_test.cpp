#include "measure/even_grid.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

constexpr double kTau = 2 * std::numbers::pi;
constexpr std::size_t kPoints = 360;

// cos(order phi + 0.3) at each sample of a run, a row.
SampleColumns wave(const Run& run, double order) {
  SampleColumns samples(1, static_cast<Eigen::Index>(run.samples()));
  for (std::size_t i = 0; i < run.samples(); ++i)
    samples(0, static_cast<Eigen::Index>(i)) = std::cos(order * run.angle[i] + 0.3);
  return samples;
}

// How far what the grid makes of a wave is from that wave at the grid's points.
double off_from_wave(const Run& run, double order) {
  const EvenGrid grid(run, kPoints);
  const Eigen::MatrixXd points = grid.project(wave(run, order));
  const std::vector<double> angles = grid.angles();
  double most = 0;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    most = std::max(most, std::abs(points(0, static_cast<Eigen::Index>(k)) - std::cos(order * angles[k] + 0.3)));
  }
  return most;
}

Run turn(std::size_t samples, Direction direction = Direction::ccw) {
  return circle_run({0, 100, -1008}, {0, 0, 0}, direction, samples);
}

}  // namespace

TEST_CASE("waves below a third of the points stay as they are") {
  for (const Direction direction : {Direction::ccw, Direction::cw}) {
    for (const std::size_t samples : {720, 3600, 50000}) {
      for (const double order : {0.0, 1.0, 3.0, 45.0, 119.0})
        CHECK(off_from_wave(turn(samples, direction), order) < 1e-3);
    }
  }
}

TEST_CASE("a wave above the grid's Nyquist does not fold into it") {
  for (const double order : {240.0, 300.0, 357.0, 361.0, 700.0, 1500.0}) {
    const Run run = turn(3600);
    CHECK(EvenGrid(run, kPoints).project(wave(run, order)).cwiseAbs().maxCoeff() < 1e-3);
  }
}

TEST_CASE("the noise of points is what the projection makes of the samples'") {
  constexpr std::size_t kSamples = 3600;
  constexpr double kEach = 10;  // samples for each point
  for (const double memory : {0.0, 0.7, 0.98}) {
    // AR(1): gamma(m) = memory^|m|; of points cov(lag) = sum over i, k of w_i w_k gamma(i - k + lag)
    const auto expected = [&](int lag) {
      const int reach = kMeyerReach * static_cast<int>(kEach);
      double sum = 0;
      for (int i = -reach; i <= reach; ++i) {
        for (int k = -reach; k <= reach; ++k) {
          const double gamma = std::pow(memory, std::abs(i - k + lag * static_cast<int>(kEach)));
          sum += meyer(i / kEach) * meyer(k / kEach) * gamma / (kEach * kEach);
        }
      }
      return sum;
    };
    const Run run = turn(kSamples);
    const EvenGrid grid(run, kPoints);
    Random random(7);
    std::normal_distribution<double> normal;
    double square = 0;
    double neighbours = 0;
    double count = 0;
    SampleColumns noise(60, static_cast<Eigen::Index>(kSamples));
    for (Eigen::Index r = 0; r < noise.rows(); ++r) {
      double now = normal(random);
      for (Eigen::Index i = 0; i < noise.cols(); ++i) {
        noise(r, i) = now;
        now = memory * now + std::sqrt(1 - memory * memory) * normal(random);
      }
    }
    const Eigen::MatrixXd points = grid.project(noise);
    for (Eigen::Index k = 20; k + 20 < points.cols(); ++k) {  // a turn's ends do not go on with such noise
      square += points.col(k).squaredNorm();
      neighbours += points.col(k).dot(points.col(k + 1));
      count += static_cast<double>(points.rows());
    }
    if (memory == 0) {
      CHECK(std::sqrt(square / count) == Approx(1 / std::sqrt(kEach)).epsilon(0.015));
      CHECK(std::abs(neighbours / square) < 0.02);
    }
    const double spread = memory > 0.9 ? 0.04 : 0.03;
    CHECK(square / count == Approx(expected(0)).epsilon(spread));
    CHECK(neighbours / count == Approx(expected(1)).margin(spread * expected(0)));
  }
}

TEST_CASE("a finer grid than a channel needs tells the same of its waves, and of their standard errors") {
  const Run run = turn(7200);
  Random random(11);
  std::normal_distribution<double> normal;
  const SampleColumns noise = SampleColumns::NullaryExpr(20, 7200, [&] { return normal(random); });
  struct Told {
    Eigen::VectorXd size;  // of order 3 in each row
    double error = 0;
  };
  const auto told_by = [&](std::size_t points) {
    const EvenGrid grid(run, points);
    const Eigen::MatrixXd on_grid = grid.project(noise);
    const auto angles = grid.angles();
    const auto count = static_cast<double>(points);
    const Eigen::VectorXd cosine = (3 * Eigen::Map<const Eigen::ArrayXd>(angles.data(), on_grid.cols())).cos();
    const double variance = on_grid.squaredNorm() / static_cast<double>(on_grid.size());
    return Told{on_grid * cosine * 2 / count, std::sqrt(2 * variance / count)};
  };
  const Told coarse = told_by(360);
  const Told fine = told_by(1440);
  CHECK((coarse.size - fine.size).norm() < 1e-3 * fine.size.norm());
  CHECK(coarse.error == Approx(fine.error).epsilon(0.02));
  CHECK(fine.error == Approx(std::sqrt(2.0 / 7200)).epsilon(0.02));
}

TEST_CASE("samples need not be even, nor begin at angle zero") {
  Run run = turn(3600);
  Random random(3);
  std::uniform_real_distribution<double> uniform(0, 0.4);
  for (double& angle : run.angle) angle += (0.2 + uniform(random)) * kTau / 3600;
  CHECK(off_from_wave(run, 3) < 2e-3);
  CHECK(off_from_wave(run, 80) < 1e-2);
}

TEST_CASE("what goes with time goes with the time that went through the same low-pass") {
  const Run run = turn(3600, Direction::cw);
  SampleColumns both(2, 3600);
  for (Eigen::Index i = 0; i < 3600; ++i) {
    both(0, i) = run.time[static_cast<std::size_t>(i)];
    both(1, i) = (7 + std::cos(run.angle[static_cast<std::size_t>(i)])) * both(0, i);
  }
  const EvenGrid grid(run, kPoints);
  const Eigen::MatrixXd points = grid.project(both);
  const std::vector<double> angles = grid.angles();
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    CHECK(points(1, k) == Approx((7 + std::cos(angles[static_cast<std::size_t>(k)])) * points(0, k)).margin(0.3));
    if (k >= 10 && k < 350) CHECK(points(0, k) == Approx(run.time[10 * static_cast<std::size_t>(k)]).epsilon(1e-3));
  }
}

TEST_CASE("of less than a turn the ends are left out") {
  Run run = turn(3600);
  run.angle.resize(1800);
  run.time.resize(1800);
  const EvenGrid grid(run, kPoints);
  REQUIRE(grid.possible());
  CHECK_FALSE(grid.whole_turn());
  const std::vector<double> angles = grid.angles();
  CHECK(angles.front() == Approx(10 * kDeg));
  CHECK(angles.back() == Approx(169 * kDeg));
  CHECK(off_from_wave(run, 40) < 1e-3);
}

TEST_CASE("samples that are too far apart are not brought to a grid") {
  CHECK(EvenGrid(turn(720), kPoints).possible());
  CHECK_FALSE(EvenGrid(turn(300), kPoints).possible());
  Run gap = turn(3600);
  gap.angle.erase(gap.angle.begin() + 1000, gap.angle.begin() + 1020);
  gap.time.erase(gap.time.begin() + 1000, gap.time.begin() + 1020);
  CHECK_FALSE(EvenGrid(gap, kPoints).possible());
}
