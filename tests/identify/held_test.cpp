#include "identify/held.hpp"

#include <cmath>

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include "identify/fit.hpp"
#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

struct Machine {
  machine::MachineModel model = pm600_like();
  physics::ForceModel forces{model};
  Unknowns unknowns = nuisances(model, forces);
  std::vector<measure::Run> runs = wider_plan(36);

  TipField field(const Eigen::VectorXd& values) const {
    return tip_field(model.rotation, runs, forces, unknowns, values);
  }
  Held hold(const Eigen::VectorXd& values, const Eigen::MatrixXd& covariance) const {
    return hold_unsure(model.rotation, runs, forces, unknowns, values, covariance);
  }
};

// What the circles tell of the unknowns, in scales.
Eigen::MatrixXd information_of(const Machine& machine, Random& random) {
  const auto runs = measured(machine.runs, machine.forces, 0.5e-6, 0.05, random);
  return fit(machine.model.rotation, runs, machine.unknowns).information;
}

double off(const TipField& field, const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  return (field.slopes * (to - from)).norm();
}

}  // namespace

TEST_CASE("a field of the tip is how far a change moves it, and without its mean where the zero is touched off") {
  const Machine machine;
  Random random(3);
  const Eigen::VectorXd values = drawn(machine.unknowns, random);
  const TipField field = machine.field(values);
  CHECK(field.places() == 4 * 4 * 12);
  const Eigen::VectorXd linear = field.slopes * (values - machine.unknowns.start());
  CHECK((field.moved - linear).norm() < 0.01 * field.moved.norm());
  CHECK(field.moved.norm() > 5e-6);
  const TipField part = touched_off(field);
  CHECK(std::abs(part.moved(Eigen::seqN(2, part.places(), 3)).mean()) < 1e-15);
  CHECK(part.moved.norm() < field.moved.norm());
}

TEST_CASE("a shift that is sure is not held, one that is not is taken back and nothing else changes at the tip") {
  const Machine machine;
  Random random(5);
  const Eigen::VectorXd values = drawn(machine.unknowns, random);
  const Eigen::VectorXd sigma = machine.unknowns.scales();
  const Eigen::MatrixXd prior = sigma.cwiseAbs2().asDiagonal();
  const Held sure = machine.hold(values, 1e-6 * prior);
  CHECK(sure.axes == 0);
  CHECK(sure.values == values);
  const Held unsure = machine.hold(values, prior);
  CHECK(unsure.axes == 3);
  CHECK(unsure.back > 2e-6);
  const TipField before = machine.field(values);
  const TipField after = machine.field(unsure.values);
  CHECK(after.moved.norm() == Approx(touched_off(before).moved.norm()).epsilon(0.01));
  CHECK((touched_off(after).moved - touched_off(before).moved).norm() < 0.2e-6);
}

TEST_CASE("machines that would be further off where they stand are not, once the shift is held") {
  const Machine machine;
  Random random(7);
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd information = information_of(machine, random);
  const Eigen::Index size = information.rows();
  const Eigen::MatrixXd covariance = (information + Eigen::MatrixXd::Identity(size, size)).inverse();
  const Eigen::VectorXd start = machine.unknowns.start();
  const Eigen::VectorXd sigma = machine.unknowns.scales();
  const Eigen::MatrixXd root = root_of(information);
  const TipField whole = machine.field(start);
  const TipField part = touched_off(whole);
  int worse_before = 0;
  int worse = 0;
  double share = 0;
  constexpr int kMachines = 60;
  for (int i = 0; i < kMachines; ++i) {
    const Eigen::VectorXd truth = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
    const Eigen::VectorXd noise = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
    const Eigen::VectorXd is = start + sigma.cwiseProduct(truth);
    const Eigen::VectorXd fitted = start + sigma.cwiseProduct(covariance * (information * truth + root * noise));
    const Held held = machine.hold(fitted, sigma.asDiagonal() * covariance * sigma.asDiagonal());
    worse_before += off(whole, fitted, is) > off(whole, start, is) ? 1 : 0;
    worse += off(whole, held.values, is) > 1.02 * off(whole, start, is) ? 1 : 0;
    CHECK(off(part, held.values, is) == Approx(off(part, fitted, is)).margin(0.3e-6));
    share += off(part, held.values, is) / off(part, start, is) / kMachines;
  }
  INFO(worse_before << " before, " << worse << " held, " << share << " left of the rest");
  CHECK(worse_before >= 3);
  CHECK(worse <= 2);
  CHECK(share < 0.8);
}

TEST_CASE("what an effect does keeps what was found, joints take its shift back") {
  Machine machine;
  machine.unknowns.add_effect("payload");
  Random random(9);
  const Eigen::MatrixXd information = information_of(machine, random);
  const auto payload = static_cast<Eigen::Index>(machine.unknowns.find("payload", "mass_kg"));
  Eigen::VectorXd values = machine.unknowns.start();
  values[payload] = 2;
  const Held held = machine.hold(values, posterior_covariance(machine.unknowns, information));
  CHECK(held.values[payload] == 2);
  CHECK(held.axes > 0);
  CHECK(held.whole.moved < 0.9 * machine.field(values).moved.norm());
}

TEST_CASE("without joints that may be off no shift is taken back") {
  const Machine machine;
  Unknowns compliance(machine.forces);
  compliance.set_prior(compliance.add_shared("axial-elasticity", "compliance_um_N"), 4e-10);
  const Eigen::VectorXd values = 1.1 * compliance.start();
  const Eigen::MatrixXd covariance = Eigen::MatrixXd::Constant(1, 1, 1.6e-19);
  const Held held = hold_unsure(machine.model.rotation, machine.runs, machine.forces, compliance, values, covariance);
  CHECK(held.values == values);
}
