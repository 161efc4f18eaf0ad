#include "identify/held.hpp"

#include <algorithm>
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

double shift_of(const TipField& field) {
  return std::sqrt(std::max(0.0, field.moved.squaredNorm() - touched_off(field).moved.squaredNorm()));
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
  const Eigen::VectorXd start = machine.unknowns.start();
  const Eigen::VectorXd values = start + 0.3 * (drawn(machine.unknowns, random) - start);
  const Eigen::VectorXd sigma = machine.unknowns.scales();
  const Eigen::MatrixXd prior = sigma.cwiseAbs2().asDiagonal();
  const Held sure = machine.hold(values, 1e-6 * prior);
  CHECK(sure.share == 0);
  CHECK(sure.values == values);
  const Held unsure = machine.hold(values, prior);
  CHECK(unsure.share > 0);
  CHECK(unsure.back > 1e-6);
  const TipField before = machine.field(values);
  const TipField after = machine.field(unsure.values);
  CHECK(shift_of(after) == Approx((1 - unsure.share) * shift_of(before)).margin(0.1e-6));
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
  double chance = 0;
  double share = 0;
  double share_off = 0;
  constexpr int kMachines = 60;
  const double matters = HoldOptions().matters;
  for (int i = 0; i < kMachines; ++i) {
    const Eigen::VectorXd truth = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
    const Eigen::VectorXd noise = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
    const Eigen::VectorXd is = start + sigma.cwiseProduct(truth);
    const Eigen::VectorXd fitted = start + sigma.cwiseProduct(covariance * (information * truth + root * noise));
    const Held held = machine.hold(fitted, sigma.asDiagonal() * covariance * sigma.asDiagonal());
    worse_before += off(whole, fitted, is) > off(whole, start, is) + matters ? 1 : 0;
    worse += off(whole, held.values, is) > off(whole, start, is) + matters ? 1 : 0;
    chance += held.whole.chance / kMachines;
    CHECK(off(part, held.values, is) == Approx(off(part, fitted, is)).margin(0.3e-6));
    share += off(whole, held.values, is) / off(whole, start, is) / kMachines;
    share_off += off(part, held.values, is) / off(part, start, is) / kMachines;
  }
  INFO(worse_before << " before, " << worse << " held, " << chance << " stated, " << share << " and " << share_off
                    << " left");
  CHECK(worse_before >= 6);
  CHECK(worse <= 4);
  CHECK(static_cast<double>(worse) / kMachines < chance + 0.05);
  CHECK(share < 0.95);
  CHECK(share_off < 0.8);
}

TEST_CASE("what an effect does keeps what was found, joints take its shift back") {
  Machine machine;
  machine.unknowns.add_effect("payload");
  Random random(9);
  const Eigen::MatrixXd information = information_of(machine, random);
  const auto payload = static_cast<Eigen::Index>(machine.unknowns.find("payload", "mass_kg"));
  Eigen::VectorXd values = machine.unknowns.start();
  values[payload] = 30;
  const Held held = machine.hold(values, posterior_covariance(machine.unknowns, information));
  CHECK(held.values[payload] == 30);
  CHECK(held.share > 0);
  CHECK(held.whole.moved < 0.9 * machine.field(values).moved.norm());
}

TEST_CASE("a shift that an effect surely makes is not held, though joints leave more doubt than one of a thousand") {
  Machine machine;
  machine.unknowns.add_effect("payload");
  Random random(9);
  const Eigen::MatrixXd information = information_of(machine, random);
  const auto payload = static_cast<Eigen::Index>(machine.unknowns.find("payload", "mass_kg"));
  Eigen::VectorXd values = machine.unknowns.start();
  values[payload] = 30;
  const Held held = machine.hold(values, 0.01 * posterior_covariance(machine.unknowns, information));
  CHECK(held.share == 0);
  CHECK(held.values == values);
  CHECK(held.shift > 3 * held.shift_doubt);
  CHECK(held.shift < 6 * held.shift_doubt);
  CHECK(held.whole.chance < 0.01);
  CHECK(held.whole.chance > held.off_the_part.chance);
}

TEST_CASE("the chance of being further off is how often it happens") {
  Random random(13);
  std::normal_distribution<double> normal;
  const auto draw = [&](Eigen::Index rows, Eigen::Index columns) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
  };
  const Eigen::MatrixXd R = 1e-6 * draw(60, 6);
  for (const double size : {0.3, 1.0, 3.0}) {
    const Eigen::VectorXd m = size * R * draw(6, 1);
    const Eigen::VectorXd f = m - 0.4 * R * draw(6, 1);
    for (const double d : {0.0, 1e-6}) {
      constexpr int kDraws = 4000;
      int worse = 0;
      for (int i = 0; i < kDraws; ++i) {
        const Eigen::VectorXd e = m + R * draw(6, 1);
        worse += (e - f).norm() > e.norm() + d ? 1 : 0;
      }
      CHECK(chance_of_worse(m, R, f, d) == Approx(static_cast<double>(worse) / kDraws).margin(0.03));
    }
  }
  const Eigen::VectorXd sure = Eigen::VectorXd::Constant(60, 1e-6);
  CHECK(chance_of_worse(sure, 0 * R, sure, 0) == 0);
  CHECK(chance_of_worse(sure, 0 * R, -sure, 0) == 1);
}

TEST_CASE("a field falls into the parts that are set up about each pose") {
  const Machine machine;
  Random random(3);
  const TipField field = machine.field(drawn(machine.unknowns, random));
  const std::vector<TipField> parts = parts_of(field);
  REQUIRE(parts.size() == 4);
  double sum = 0;
  for (const TipField& part : parts) {
    CHECK(part.places() == 4 * 12);
    CHECK(part.slopes.cols() == field.slopes.cols());
    sum += part.moved.squaredNorm() / 4;
  }
  CHECK(sum == Approx(field.moved.squaredNorm()));
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
