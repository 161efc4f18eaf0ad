#include "measure/setup.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

void measure_with(Run& run, const RunSimulation& simulation, const Vector3<double>& ball_off, double bar_off) {
  const Eigen::VectorXd radial = simulation.radial(ideal_ball(run) + ball_off, run.bar_length() + bar_off);
  run.radial.assign(radial.begin(), radial.end());
}

}  // namespace

TEST_CASE("the set-up is found again, its height together with the bar where they read alike") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  Run run = circle_run({0, 100, -1008}, {-22, 0, 0});
  const RunSimulation simulation = simulate_run(machine, forces, run);
  measure_with(run, simulation, {30 * kUm, -200 * kUm, 0}, 12 * kUm);
  const Setup setup = fit_setup(run, simulation);
  CHECK(setup.converged);
  CHECK_FALSE(setup.fits_height);
  const Vector3<double> off = (setup.ball_W - ideal_ball(run)) / kUm;
  CHECK(off.x() == Approx(30).margin(1e-6));
  CHECK(off.y() == Approx(-200).margin(1e-6));
  CHECK((setup.bar - run.bar_length()) / kUm == Approx(12).margin(1e-6));
  CHECK(radial_residuals(run, simulation, setup).cwiseAbs().maxCoeff() < 1e-12);

  // 20 um too low reads as a bar that is shorter by 42/150 of it, to some nanometres
  measure_with(run, simulation, {0, 0, -20 * kUm}, 0);
  CHECK(radial_residuals(run, simulation, fit_setup(run, simulation)).cwiseAbs().maxCoeff() < 0.02 * kUm);
}

TEST_CASE("what is left has neither a mean nor a first harmonic") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  Run run = circle_run({-70, -70, -1008}, {-17, -17, 0}, Direction::cw);
  const RunSimulation simulation = simulate_run(machine, forces, run);
  Random random(41);
  for (double& reading : run.radial) reading = uniform(random, -50 * kUm, 50 * kUm);
  const Setup setup = fit_setup(run, simulation);
  const Eigen::VectorXd left = radial_residuals(run, simulation, setup);
  double cos_part = 0;
  for (Eigen::Index i = 0; i < left.size(); ++i) cos_part += left[i] * std::cos(run.angle[static_cast<std::size_t>(i)]);
  CHECK(left.mean() == Approx(0).margin(1e-9));
  CHECK(cos_part / static_cast<double>(left.size()) == Approx(0).margin(1e-7));
}
