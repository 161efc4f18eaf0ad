#include "identify/posterior/expected_tip.hpp"

#include <catch2/catch.hpp>

#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using identify::Posterior;

namespace {

// One number known to `sigma`: all struts longer together, which moves the tip about as much and more.
Posterior offsets_known_to(double sigma) {
  const machine::MachineModel machine = pm600_like();
  Posterior posterior{identify::Unknowns(physics::ForceModel(machine))};
  for (int strut = 0; strut < 6; ++strut)
    posterior.unknowns.set_prior(posterior.unknowns.add("strut-offset", "length_um", strut), sigma);
  posterior.states.push_back(
      {"", 1, posterior.unknowns.start(), sigma * sigma * Eigen::MatrixXd::Identity(6, 6), 1, Eigen::MatrixXd(6, 0)});
  return posterior;
}

}  // namespace

TEST_CASE("what is expected at the tip grows with what is not known, and adds up in squares") {
  const machine::RotationOrder order = pm600_like().rotation;
  const std::vector<measure::Run> runs = wider_plan(36);
  const double once = identify::expected_at_tip(order, runs, offsets_known_to(10e-6));
  CHECK(once > 10e-6);
  CHECK(once < 100e-6);
  CHECK(identify::expected_at_tip(order, runs, offsets_known_to(30e-6)) == Approx(3 * once));
  Posterior more = offsets_known_to(10e-6);
  more.unexplained = once / std::sqrt(3);
  CHECK(identify::expected_at_tip(order, runs, more) == Approx(std::sqrt(2) * once));
  Posterior moved = offsets_known_to(10e-6);
  moved.states[0].moved = 10e-6 * Eigen::MatrixXd::Identity(6, 6);
  CHECK(identify::expected_at_tip(order, runs, moved) == Approx(std::sqrt(2) * once));
  CHECK(identify::expected_at_tip(order, {}, more) == 0);
}

TEST_CASE("a model is less sure than the one as given from twice as much on") {
  const machine::RotationOrder order = pm600_like().rotation;
  const std::vector<measure::Run> runs = wider_plan(36);
  const auto less = [&](double given, double learnt) {
    return identify::less_sure(order, runs, offsets_known_to(given), offsets_known_to(learnt));
  };
  CHECK_FALSE(less(10e-6, 5e-6));
  CHECK_FALSE(less(10e-6, 18e-6));
  REQUIRE(less(10e-6, 25e-6));
  CHECK(less(10e-6, 25e-6)->learnt == Approx(2.5 * less(10e-6, 25e-6)->given));
  CHECK_FALSE(less(0.1e-6, 1e-6));  // of no account
}

TEST_CASE("a model that moves the tip by far more than it is unsure of is no less sure") {
  const machine::RotationOrder order = pm600_like().rotation;
  const std::vector<measure::Run> runs = wider_plan(36);
  const auto less = [&](double shift) {
    const Posterior before = offsets_known_to(25e-6);
    const Eigen::VectorXd there = (before.unknowns.start().array() + shift).matrix();
    Posterior learnt = identify::about(before, before.unknowns.at(there));
    learnt.states[0].mean = there;
    return identify::less_sure(order, runs, offsets_known_to(10e-6), learnt).has_value();
  };
  CHECK(less(0));
  CHECK(less(10e-6));
  CHECK_FALSE(less(200e-6));
  CHECK_FALSE(less(-200e-6));
}
