#include "identify/equations/objective.hpp"

#include <catch2/catch.hpp>

#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

NoiseModel coloured() {
  NoiseModel noise;
  noise.channels.fill({0.05, 0.4, 1});
  noise.channels[kRadial] = {0.5e-6, 0.6, 1};
  return noise;
}

}  // namespace

TEST_CASE("the equations of a run hold for small changes of unknowns and set-up") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  Random random(51);
  const measure::Run run =
      measured({circle_run({-40, 60, -1008}, {-12, 7, 3}, measure::Direction::cw, 24)}, unknowns.forces(), 0, 0, random)
          .front();
  const physics::ForceModel forces = unknowns.at(unknowns.start());
  const Sensitivity sensitivity(forces, unknowns);
  measure::Setup setup = ideal_setup(run);
  const RunEquations before = run_equations(run, simulate_run(machine.rotation, forces, run, &sensitivity), setup);
  REQUIRE(before.slopes.rows() == 7 * 24);

  const Eigen::VectorXd change = 1e-3 * (drawn(unknowns, random) - unknowns.start());
  const Eigen::Vector3d step(2e-9, -3e-9, 1e-9);
  move_setup(setup, step);
  const physics::ForceModel moved = unknowns.at(unknowns.start() + change);
  const RunEquations after = run_equations(run, simulate_run(machine.rotation, moved, run), setup);
  CHECK(after.slopes.size() == 0);
  Eigen::VectorXd expected = before.residual - before.slopes * change;
  expected.head(24) -= before.setup_slopes * step;
  CHECK((after.residual - expected).head(24).cwiseAbs().maxCoeff() < 1e-13);
  CHECK((after.residual - expected).tail(144).cwiseAbs().maxCoeff() < 1e-8);
  CHECK((after.residual - before.residual).tail(144).cwiseAbs().maxCoeff() > 5e-5);
}

TEST_CASE("the gradient of the misfit equals its finite differences, set-ups refitted, outliers included") {
  const machine::MachineModel machine = pm600_like();
  Random random(52);
  const Unknowns all = nuisances(machine, physics::ForceModel(machine));
  std::vector<measure::Run> runs = measured(papers_plan(36), all.at(drawn(all, random)), 0.5e-6, 0.05, random);
  runs[0].radial[5] += 60e-6;
  runs[1].torque[2][9] += 4;
  Objective objective(machine.rotation, runs, all);
  objective.set_noise(coloured());
  const Eigen::VectorXd at = all.start();
  const NormalEquations normal = objective.evaluate(at, true);
  CHECK(normal.rows == 2 * 7 * 36);
  for (std::size_t i = 0; i < all.size(); i += 5) {
    INFO(all[i].label);
    const auto k = static_cast<Eigen::Index>(i);
    const double h = 1e-3;
    Eigen::VectorXd beside = at;
    beside[k] += h * all[i].scale;
    const double later = objective.evaluate(beside, false).misfit;
    beside[k] -= 2 * h * all[i].scale;
    const double before = objective.evaluate(beside, false).misfit;
    CHECK((later - before) / (4 * h) == Approx(normal.gradient[k]).epsilon(1e-3).margin(1e-3 * normal.gradient.norm()));
  }
  CHECK(normal.information.isApprox(normal.information.transpose()));
}

TEST_CASE("set-ups are found, and evaluation does not depend on what was evaluated before") {
  const machine::MachineModel machine = pm600_like();
  Random random(53);
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  const std::vector<measure::Run> runs = measured(papers_plan(60), unknowns.forces(), 0, 0, random);
  Objective objective(machine.rotation, runs, unknowns);
  objective.set_noise(coloured());
  const double misfit = objective.evaluate(unknowns.start(), false).misfit;
  CHECK(misfit < 1e-3);  // the ball's height changes readings by nanometres in ways that its x, y and the bar do not
  for (const measure::Setup& setup : objective.setups()) CHECK(setup.converged);
  objective.evaluate(drawn(unknowns, random), true);
  CHECK(objective.evaluate(unknowns.start(), false).misfit == Approx(misfit).margin(1e-9));
}
