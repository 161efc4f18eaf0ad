#include "measure/thinning.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <sched.h>

#include "machine/machines.hpp"
#include "measure/friction_turns.hpp"
#include "measure/runs.hpp"
#include "measure/simulation.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

// What a machine with friction in its screws reads, many times a turn.
std::vector<Run> long_runs(std::size_t samples) {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  Dataset dataset;
  for (const Direction direction : {Direction::ccw, Direction::cw})
    dataset.runs.push_back(circle_run({0, 100, -1008}, {-18, 0, 0}, direction, samples));
  return simulated(machine, forces, std::move(dataset)).runs;
}

double most_off(const Run& run) {
  const RunSimulation model = simulate_run(pm600_like(), physics::ForceModel(pm600_like()), run);
  const Eigen::VectorXd radial = model.radial(ideal_ball(run), run.bar_length());
  return (radial - Eigen::Map<const Eigen::VectorXd>(run.radial.data(), radial.size())).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("the model says of a record that was made short what it said of the long one, reversals included") {
  for (const Run& run : thinned(pm600_like(), long_runs(7200)).runs) {
    REQUIRE(run.samples() == 360);
    CHECK(run.torque[5].size() == 360);
    CHECK(most_off(run) < 0.03e-6);
    Run without = run;
    without.signs.clear();
    CHECK(most_off(without) > 0.5e-6);
  }
}

TEST_CASE("what became of long records is said") {
  std::vector<Run> runs = long_runs(3600);
  runs.push_back(circle_run({0, 100, -1008}, {-18, 0, 0}, Direction::ccw, 719));
  const Thinned made = thinned(pm600_like(), runs);
  CHECK(made.thinning.runs == 3);
  CHECK(made.thinning.thinned == 2);
  CHECK(made.thinning.points == 360);
  CHECK(made.thinning.longest == 3600);
  CHECK(made.runs[2].angle == runs[2].angle);
  CHECK(made.runs[2].signs.empty());
}

TEST_CASE("a fit takes runs without samples where struts turn round, however long they were") {
  for (const std::size_t samples : {120, 3600}) {
    const Run run = circle_run({0, 100, -1008}, {0, 0, 0}, Direction::cw, samples);
    const Thinned made = fit_runs(pm600_like(), {run});
    const std::size_t whole = thinned(pm600_like(), {run}).runs.front().samples();
    CHECK(made.runs.front().samples() < whole);
    CHECK(made.runs.front().samples() > whole * 3 / 4);
    CHECK(friction_turns(pm600_like(), physics::ForceModel(pm600_like()), made.runs.front()).empty());
  }
}

TEST_CASE("records that are short enough stay as they are") {
  for (const std::size_t samples : {120, 360, 719}) {
    const Run before = circle_run({0, 100, -1008}, {0, 0, 0}, Direction::cw, samples);
    const Thinned made = thinned(pm600_like(), {before});
    CHECK(made.thinning.thinned == 0);
    CHECK(made.runs.front().angle == before.angle);
    CHECK(made.runs.front().radial == before.radial);
  }
}

TEST_CASE("a fine wave in one motor's torque makes the grid as fine as it needs") {
  std::vector<Run> runs = long_runs(7200);
  for (Run& run : runs) {
    for (std::size_t i = 0; i < run.samples(); ++i) run.torque[3][i] += 0.02 * std::cos(200 * run.angle[i]);
  }
  const Thinned made = thinned(pm600_like(), runs);
  CHECK(made.thinning.points == 720);
  const Run& run = made.runs[1];
  const RunSimulation model = simulate_run(pm600_like(), physics::ForceModel(pm600_like()), run);
  int off = 0;  // near a turn of friction, where readings are filled in
  for (std::size_t k = 0; k < run.samples(); ++k) {
    const double left = run.torque[3][k] - model.samples[k].torque[3];
    if (std::abs(left - 0.02 * std::cos(200 * run.angle[k])) > 1e-3) ++off;
  }
  CHECK(off < 0.25 * 720);
}

TEST_CASE("a screw of a fine lead makes the grid fine enough for waves as long") {
  machine::MachineModel fine = pm600_like();
  for (machine::ModelValue& value : fine.values) {
    if (value.key == "lead_mm") value.values.assign(machine::kStruts, 5 * kMm);
  }
  CHECK(thinned(fine, long_runs(3600)).thinning.points == 720);  // 181 periods a turn
}

TEST_CASE("records made short are the same for any number of threads") {
  cpu_set_t all;
  REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
  const std::vector<Run> runs = long_runs(3600);
  const Thinned many = thinned(pm600_like(), runs);
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &all)) {
      CPU_SET(cpu, &one);
      break;
    }
  }
  REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
  const Thinned alone = thinned(pm600_like(), runs);
  REQUIRE(sched_setaffinity(0, sizeof all, &all) == 0);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    CHECK(many.runs[i].radial == alone.runs[i].radial);
    CHECK(many.runs[i].torque == alone.runs[i].torque);
    CHECK(many.runs[i].signs == alone.runs[i].signs);
  }
}
