#include "measure/planned_run.hpp"

#include <numbers>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"

using namespace plumbline;
using namespace plumbline::measure;

TEST_CASE("samples lie evenly on the turn, at the times that the feed takes there") {
  Run run;
  run.radius = 0.1;
  run.feed = 0.01;
  lay_samples(run, 4, true, false);
  REQUIRE(run.samples() == 4);
  CHECK(run.angle[1] == Approx(std::numbers::pi / 2));
  CHECK(run.angle[3] == Approx(3 * std::numbers::pi / 2));  // the turn's end is its begin
  CHECK(run.time[0] == 0);
  CHECK(run.time[2] == Approx(10 * std::numbers::pi));  // half the circle: pi 0.1 m at 0.01 m/s
  CHECK(run.radial == std::vector<double>(4, 0));
  CHECK_FALSE(run.has_torque());
}

TEST_CASE("a clockwise run counts its angles down, and new samples take the place of old ones") {
  Run run = testing::circle_run({0, 100, -1008}, {0, 0, 0}, Direction::cw, 100);
  lay_samples(run, 8, false, true);
  CHECK(run.samples() == 8);
  CHECK(run.angle[1] == Approx(-std::numbers::pi / 4));
  CHECK(run.time[1] > 0);
  CHECK_FALSE(run.has_radial());
  for (const auto& torque : run.torque) CHECK(torque.size() == 8);
}

TEST_CASE("a circle is within the limits where each of its samples is") {
  const machine::MachineModel machine = testing::pm600_like();
  CHECK(within_limits(machine, testing::circle_run({0, 0, -1008}, {0, 0, 0})));
  CHECK(within_limits(machine, testing::circle_run({0, 0, -1008}, {24, 0, 0})));
  CHECK_FALSE(within_limits(machine, testing::circle_run({0, 0, -1008}, {26, 0, 0})));  // 25 deg are allowed
  const double reach_mm = machine.limits.travel[0].upper / kMm;
  CHECK(within_limits(machine, testing::circle_run({reach_mm - 145, 0, -1008}, {0, 0, 0})));
  CHECK_FALSE(within_limits(machine, testing::circle_run({reach_mm - 143, 0, -1008}, {0, 0, 0})));  // radius 144 mm
}
