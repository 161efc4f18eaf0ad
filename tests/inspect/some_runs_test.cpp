// What is wrong alike with some of the runs.
#include "inspect/some_runs.hpp"

#include <functional>
#include <utility>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using inspect::Fault;
using inspect::FaultKind;
using measure::Run;

namespace {

struct OfSome {
  FaultKind kind;
  double value = 0;  // that is told; nil: none
  std::function<void(Run&)> spoil;
};

std::vector<OfSome> cases() {
  const auto torques_by = [](double by) {
    return [by](Run& run) {
      for (auto& torque : run.torque) multiply(torque, by);
    };
  };
  return {
      {FaultKind::torque_unit, 1 / 0.85, torques_by(1 / 0.85)},
      {FaultKind::torque_unit, 2.5, torques_by(2.5)},
      {FaultKind::torque_unit, 1 / 2.5, torques_by(1 / 2.5)},
      {FaultKind::motor_sign, 0, torques_by(-1)},
      {FaultKind::motor_sign, 0, [](Run& run) { multiply(run.torque[2], -1); }},
      {FaultKind::torque_unit, 2, [](Run& run) { multiply(run.torque[4], 2); }},
      {FaultKind::motors_swapped, 0, [](Run& run) { std::swap(run.torque[0], run.torque[1]); }},
      {FaultKind::motors_swapped, 2,
       [](Run& run) {
         std::swap(run.torque[0], run.torque[1]);
         std::swap(run.torque[2], run.torque[3]);
       }},
      {FaultKind::bar_sign, 0, [](Run& run) { multiply(run.radial, -1); }},
      {FaultKind::bar_unit, 1e-3, [](Run& run) { multiply(run.radial, 1e-3); }},
      {FaultKind::direction, 0,
       [](Run& run) {
         run.direction = run.direction == measure::Direction::cw ? measure::Direction::ccw : measure::Direction::cw;
         for (double& angle : run.angle) angle = -angle;
       }},
      {FaultKind::angle_zero, -90 * kDeg,
       [](Run& run) {
         for (double& angle : run.angle) angle += 90 * kDeg;
       }},
  };
}

void check(const std::vector<std::size_t>& some, const OfSome& of) {
  INFO(to_text(of.kind) << " " << of.value << " in " << some.size() << " runs");
  Measured measured(11);
  for (const std::size_t run : some) of.spoil(measured.runs[run]);
  const std::vector<Fault> faults = measured.inspection().faults;
  REQUIRE(faults.size() == 1);
  INFO("found " << to_text(faults[0].kind) << " " << (faults[0].values.empty() ? 0 : faults[0].values[0]));
  CHECK(faults[0].kind == of.kind);
  CHECK(faults[0].runs == some);
  CHECK(faults[0].blocks);
  CHECK_FALSE(faults[0].all);
  CHECK(faults[0].after < 1.2);
  if (faults[0].values.empty() || of.value == 0) return;
  const double within = of.kind == FaultKind::bar_unit ? 0.5 : 0.1;  // torques have more of the factor
  CHECK(faults[0].values[0] == Approx(of.value).epsilon(within));
}

}  // namespace

TEST_CASE("what is wrong alike with half of the runs is told of these") {
  for (const OfSome& of : cases()) check({4, 5, 6, 7}, of);
}

TEST_CASE("the same of few runs, of most, and of such that do not follow each other") {
  for (const std::size_t number : {0U, 4U, 7U, 8U}) {
    const OfSome of = cases()[number];
    for (const std::vector<std::size_t>& some : {std::vector<std::size_t>{1, 6}, {0, 2, 5, 7}, {0, 1, 2, 3, 5, 6}}) {
      check(some, of);
    }
  }
}

TEST_CASE("what is wrong with one run is not told of all the others") {
  for (const auto& [one, other] : {std::pair{1, 4}, {0, 1}, {2, 5}}) {
    INFO("motors " << one << " and " << other);
    Measured measured(11);
    std::swap(measured.runs[5].torque[static_cast<std::size_t>(one)],
              measured.runs[5].torque[static_cast<std::size_t>(other)]);
    const std::vector<Fault> faults = measured.inspection().faults;
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].kind == FaultKind::motors_swapped);
    CHECK(faults[0].runs == std::vector<std::size_t>{5});
  }
}
