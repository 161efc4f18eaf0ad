#include "identify/fit.hpp"

#include <catch2/catch.hpp>

#include "identify/identify.hpp"
#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

double root_mean_z2(const Fit& fit, const Eigen::VectorXd& truth) {
  double sum = 0;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double z = (fit.values[k] - truth[k]) / fit.standard_error(i);
    sum += z * z;
  }
  return std::sqrt(sum / static_cast<double>(fit.unknowns.size()));
}

}  // namespace

TEST_CASE("free parameters of exact data are found exactly") {
  const machine::MachineModel machine = pm600_like();
  Unknowns unknowns = compliance_unknowns(physics::ForceModel(machine));
  const std::size_t play = unknowns.add("backlash", "width_um", 2);
  Eigen::VectorXd truth = unknowns.start();
  truth[0] *= 1.1;
  truth[1] *= 0.93;
  truth[static_cast<Eigen::Index>(play)] = 4e-6;
  Random random(61);
  const Fit found = fit(machine.rotation, measured(wider_plan(36), unknowns.at(truth), 0, 0, random), unknowns);
  CHECK(found.converged);
  for (Eigen::Index i = 0; i < truth.size(); ++i) CHECK(found.values[i] == Approx(truth[i]).epsilon(1e-3));
  const physics::ForceModel forces = found.forces();
  CHECK(forces.parameters[static_cast<std::size_t>(forces.find("backlash", "width_um") + 2)] ==
        Approx(4e-6).epsilon(1e-3));
}

TEST_CASE("the truth lies within the standard errors when joints, masses and noise are as [uncertainty] says") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  double sum = 0;
  constexpr int kDrawn = 3;
  for (unsigned seed = 0; seed < kDrawn; ++seed) {
    INFO("seed " << seed);
    Random random(700 + seed);
    const Eigen::VectorXd truth = drawn(unknowns, random);
    const auto runs = measured(wider_plan(), unknowns.at(truth), 0.5e-6, 0.05, random);
    const Fit found = fit(machine.rotation, runs, unknowns);
    CHECK(found.converged);
    CHECK(found.noise.channels[kRadial].sigma == Approx(0.5e-6).epsilon(0.15));
    CHECK(found.noise.channels[3].memory == Approx(0.6).margin(0.1));
    CHECK(found.misfit / static_cast<double>(found.readings) == Approx(1).margin(0.1));
    CHECK(found.fitted_degrees > 15);
    CHECK(found.fitted_degrees < 55);
    sum += root_mean_z2(found, truth);
  }
  CHECK(sum / kDrawn > 0.8);  // 55 unknowns, three times: 1 +- 0.06
  CHECK(sum / kDrawn < 1.2);
}

TEST_CASE("a fit that is stopped before its end says so") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = compliance_unknowns(physics::ForceModel(machine));
  Eigen::VectorXd truth = unknowns.start();
  truth[0] *= 1.5;
  Random random(62);
  const auto runs = measured(wider_plan(36), unknowns.at(truth), 0, 0, random);
  CHECK(fit(machine.rotation, runs, unknowns).converged);
  const Fit stopped = fit(machine.rotation, runs, unknowns, {.most_iterations = 0});
  CHECK_FALSE(stopped.converged);
  CHECK_FALSE(stopped.stopped_because.empty());
}

TEST_CASE("outliers hardly move the result") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  Random random(62);
  const Eigen::VectorXd truth = drawn(unknowns, random);
  auto runs = measured(wider_plan(), unknowns.at(truth), 0.5e-6, 0.05, random);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].radial[10 + i] += 80e-6;
    runs[i].torque[i % 6][20 + 2 * i] -= 30;
  }
  CHECK(root_mean_z2(fit(machine.rotation, runs, unknowns), truth) < 1.4);
}

TEST_CASE("bounds hold: friction that is not there comes out as zero, not below") {
  const machine::MachineModel machine = pm600_like();
  Unknowns unknowns{physics::ForceModel(machine)};
  unknowns.add("screw-coulomb", "force_N", 1);
  Eigen::VectorXd truth(1);
  truth << -20;
  Random random(63);
  const Fit found =
      fit(machine.rotation, measured(papers_plan(60), unknowns.at(truth), 0.5e-6, 0.05, random), unknowns);
  CHECK(found.values[0] == Approx(0).margin(1e-9));
}

TEST_CASE("what data do not touch stays where its prior has it, and what nothing tells has no finite error") {
  const machine::MachineModel machine = pm600_like();
  Unknowns unknowns{physics::ForceModel(machine)};
  unknowns.set_prior(unknowns.add("torque-scale", "percent", 0), 0.02);
  unknowns.add("torque-scale", "percent", 1);
  unknowns.set_prior(unknowns.add_shared("axial-elasticity", "compliance_um_N"), 1e-9);
  Random random(64);
  auto runs = measured(papers_plan(60), unknowns.forces(), 0.5e-6, 0.05, random);
  for (measure::Run& run : runs) {
    for (auto& torque : run.torque) torque.clear();
  }
  const Fit found = fit(machine.rotation, runs, unknowns);
  CHECK(found.values[0] == Approx(0).margin(1e-9));
  CHECK(found.standard_error(0) == Approx(0.02));
  CHECK(std::isinf(found.standard_error(1)));
  CHECK(found.standard_error(2) < 0.5e-9);
  const Observability known = observability(found, runs);
  CHECK(known.nothing == std::vector<std::size_t>{1});
  CHECK(known.little == std::vector<std::size_t>{0});
}

TEST_CASE("a fit of many samples starts from a few of them and comes out as one of all") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  Random random(65);
  const auto runs = measured(papers_plan(300), unknowns.at(drawn(unknowns, random)), 0.5e-6, 0.05, random);
  const Fit at_once = fit(machine.rotation, runs, unknowns, {.coarse_samples = 1000});
  const Fit in_two = fit(machine.rotation, runs, unknowns, {.coarse_samples = 60});
  CHECK(in_two.iterations < at_once.iterations);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    CHECK(std::abs(at_once.values[k] - in_two.values[k]) < 0.05 * at_once.standard_error(i));
  }
}
