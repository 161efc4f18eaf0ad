#include "measure/friction_turns.hpp"

#include <catch2/catch.hpp>

#include "machine/model_file.hpp"
#include "measure/runs.hpp"
#include "measure/simulation.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

struct Bench {
  machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  physics::ForceModel forces{machine};

  std::vector<measure::FrictionTurn> turns(const measure::Run& run,
                                           const measure::FrictionTurnOptions& options = {}) const {
    return measure::friction_turns(machine, forces, run, options);
  }
  /// Readings of the model, and of a bar and a motor that have an error of their own.
  measure::Run measured(std::size_t samples) const {
    measure::Run run = testing::circle_run({0, 0, -1008}, {0, 0, 0}, measure::Direction::ccw, samples);
    const measure::RunSimulation simulation = measure::simulate_run(machine, forces, run);
    const Eigen::VectorXd radial = simulation.radial(measure::ideal_ball(run), run.bar_length());
    for (std::size_t i = 0; i < samples; ++i) {
      run.radial[i] = radial[static_cast<Eigen::Index>(i)] + 3e-6;
      for (std::size_t j = 0; j < 6; ++j)
        run.torque[j][i] = simulation.samples[i].torque[static_cast<Eigen::Index>(j)] - 0.2;
    }
    return run;
  }
};

std::size_t count_of(const std::vector<measure::FrictionTurn>& turns) {
  std::size_t count = 0;
  for (const measure::FrictionTurn& turn : turns) count += turn.end - turn.begin;
  return count;
}

const Vector3<double> kMiddle(0, 0, -1008);

}  // namespace

TEST_CASE("each strut turns round twice on a circle, and its friction within a way that is stated") {
  Bench bench;
  const measure::Run run = testing::circle_run(kMiddle, {0, 0, 0}, measure::Direction::ccw, 3600);
  const auto turns = bench.turns(run);
  CHECK(turns.size() <= 12);
  CHECK(turns.size() >= 6);  // of two struts at a time, as the machine is symmetric
  for (const measure::FrictionTurn& turn : turns) {
    CHECK(turn.begin <= turn.turned);
    CHECK(turn.turned < turn.end);
    CHECK(turn.turned - turn.begin < turn.end - turn.turned);
  }
  CHECK(count_of(turns) > 6 * 8);
  CHECK(count_of(bench.turns(run, {10e-6})) < count_of(turns));
}

TEST_CASE("samples that are far apart are left out only where they fall on a turn") {
  Bench bench;
  const measure::Run run = testing::circle_run({0, 100, -1008}, {0, 0, 0}, measure::Direction::cw, 120);
  const std::size_t turning = count_of(bench.turns(run));
  CHECK(turning > 0);
  CHECK(turning <= 12);
  const measure::Run left = measure::without_friction_turns(bench.machine, bench.forces, run);
  CHECK(left.samples() == 120 - turning);
  CHECK(left.radial.size() == left.samples());
  CHECK(left.torque[5].size() == left.samples());
}

TEST_CASE("where they were too many none is left out") {
  Bench bench;
  CHECK(bench.turns(testing::circle_run(kMiddle, {0, 0, 0}, measure::Direction::ccw, 3600), {1}).empty());
}

TEST_CASE("what a turn is filled with is the model, and what it leaves beside the turn") {
  Bench bench;
  const measure::Run original = bench.measured(3600);
  measure::Run run = original;
  for (const measure::FrictionTurn& turn : bench.turns(run)) {
    for (std::size_t i = turn.begin; i < turn.end; ++i) {
      run.radial[i] += 20e-6;
      run.torque[2][i] -= 5;
    }
  }
  measure::fill_friction_turns(bench.machine, bench.forces, run);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    if (std::abs(run.radial[i] - original.radial[i]) > 1e-12 ||
        std::abs(run.torque[2][i] - original.torque[2][i]) > 1e-9)
      FAIL("sample " << i);
  }
}
