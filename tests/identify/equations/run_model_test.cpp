// That residuals move as their slopes say is in objective_test.cpp, that slopes are right in sensitivity_test.cpp.
#include "identify/equations/run_model.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"
#include "measure/simulation.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::identify;

TEST_CASE("a run simulated for its equations is the one that measure simulates") {
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  const measure::Run run = testing::circle_run({0, 100, -1008}, {-18, 0, 0}, measure::Direction::cw, 8);
  const SimulatedRun simulated = simulate_run(machine.rotation, forces, run);
  const measure::RunSimulation expected = measure::simulate_run(machine, forces, run);
  REQUIRE(simulated.tip_W.cols() == 8);
  CHECK(simulated.slopes.size() == 0);
  for (Eigen::Index i = 0; i < 8; ++i) {
    const auto& sample = expected.samples[static_cast<std::size_t>(i)];
    CHECK((simulated.torque.col(i) - sample.torque).norm() < 1e-12);
  }
  const Eigen::VectorXd radial = expected.radial(measure::ideal_ball(run), run.bar_length());
  const RunEquations equations = run_equations(run, simulated, ideal_setup(run));
  CHECK((equations.residual.head(8) + radial).norm() < 1e-12);  // readings of zero minus what is simulated
}

TEST_CASE("the reading of the bar is the tip's distance from the ball, and moves with the set-up") {
  measure::Run run = testing::circle_run({0, 0, 0}, {0, 0, 0}, measure::Direction::ccw, 1);
  run.radial = {0.25};
  for (auto& torque : run.torque) torque.clear();
  SimulatedRun simulated;
  simulated.tip_W = Eigen::Vector3d(3, 4, 12);
  simulated.torque.setZero(6, 1);
  const RunEquations equations = run_equations(run, simulated, {{0, 0, 0}, 12.5});
  CHECK(equations.channels == std::vector<int>{kRadial});
  CHECK(equations.residual[0] == Approx(0.25 - (13 - 12.5)));
  CHECK(equations.setup_slopes(0, 0) == Approx(-3 / 13.0));
  CHECK(equations.setup_slopes(0, 1) == Approx(-4 / 13.0));
  CHECK(equations.setup_slopes(0, 2) == -1);
}

TEST_CASE("channels stand one behind the other, those that were measured") {
  measure::Run run = testing::circle_run({0, 0, 0}, {0, 0, 0}, measure::Direction::ccw, 2);
  run.radial.clear();
  for (std::size_t j = 0; j < 6; ++j) run.torque[j].assign(2, static_cast<double>(j));
  SimulatedRun simulated;
  simulated.tip_W = Eigen::Matrix3Xd::Zero(3, 2);
  simulated.torque.setConstant(6, 2, 0.5);
  const RunEquations equations = run_equations(run, simulated, {});
  CHECK(equations.channels == std::vector<int>{1, 2, 3, 4, 5, 6});
  CHECK_FALSE(equations.first_row(kRadial));
  REQUIRE(equations.first_row(3));
  CHECK(*equations.first_row(3) == 4);
  CHECK(equations.residual[4] == Approx(2 - 0.5));
  CHECK(equations.setup_slopes.size() == 0);
  CHECK(channel_name(0) == "radial");
  CHECK(channel_name(6) == "torque6");
  CHECK(channel_name(kTrackerTilt) == "tracker_tilt");
}

TEST_CASE("a set-up moves by the ball's x and y and the bar's length") {
  measure::Setup setup{{1, 2, 3}, 4};
  move_setup(setup, Eigen::Vector3d(0.5, -0.25, 0.125));
  CHECK(setup.ball_W == Vector3<double>(1.5, 1.75, 3));
  CHECK(setup.bar == 4.125);
}

TEST_CASE("a run that the machine cannot make is refused") {
  const machine::MachineModel machine = testing::pm600_like();
  const measure::Run far = testing::circle_run({0, 0, -1008}, {0, 0, 90}, measure::Direction::ccw, 4);
  CHECK(testing::refusal_of([&] { simulate_run(machine.rotation, physics::ForceModel(machine), far); }).code ==
        "simulate-unreachable");
}
