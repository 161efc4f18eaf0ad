#include "diagnose/readings/channel_flaw.hpp"

#include <catch2/catch.hpp>

#include "diagnose/diagnose.hpp"
#include "diagnose/readings/residuals.hpp"
#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

std::vector<measure::Run> of_the_model() {
  testing::Random random(3);
  return testing::measured(testing::wider_plan(60), physics::ForceModel(testing::pm600_like()), 0.5e-6, 0.05, random);
}

void scale(std::vector<measure::Run>& runs, std::size_t motor, double by) {
  for (measure::Run& run : runs) {
    for (double& torque : run.torque[motor]) torque *= by;
  }
}

std::optional<ChannelFlaw> flaw_of(const std::vector<measure::Run>& runs) {
  const machine::MachineModel machine = testing::pm600_like();
  return channel_flaw(runs, residuals(machine, runs, physics::ForceModel(machine), {}));
}

}  // namespace

TEST_CASE("torques that are as the model has them, or as a mass makes them, are no flaw") {
  std::vector<measure::Run> runs = of_the_model();
  CHECK_FALSE(flaw_of(runs));
  for (std::size_t j = 0; j < 6; ++j) scale(runs, j, 1.4);
  CHECK_FALSE(flaw_of(runs));
  for (measure::Run& run : runs) {
    for (auto& torque : run.torque) torque.clear();
  }
  CHECK_FALSE(flaw_of(runs));
}

TEST_CASE("a motor whose torque has the other sign is told from every effect") {
  for (const std::size_t motor : {0, 3}) {
    std::vector<measure::Run> runs = of_the_model();
    scale(runs, motor, -1);
    const std::optional<ChannelFlaw> flaw = flaw_of(runs);
    REQUIRE(flaw);
    CHECK(flaw->kind == ChannelFlaw::Kind::sign);
    CHECK(flaw->motors == std::vector<std::size_t>{motor});
    CHECK(flaw->factors[0] == Approx(-1).epsilon(0.05));
  }
  std::vector<measure::Run> all = of_the_model();
  for (std::size_t j = 0; j < 6; ++j) scale(all, j, -1);
  REQUIRE(flaw_of(all));
  CHECK(flaw_of(all)->motors.size() == 6);
}

TEST_CASE("torques in per cent of the rated one, or in another unit, are told from every effect") {
  for (const double by : {100.0 / 16, 100.0, 0.102}) {
    std::vector<measure::Run> runs = of_the_model();
    for (std::size_t j = 0; j < 6; ++j) scale(runs, j, by);
    const std::optional<ChannelFlaw> flaw = flaw_of(runs);
    REQUIRE(flaw);
    CHECK(flaw->kind == ChannelFlaw::Kind::unit);
    CHECK(flaw->motors.size() == 6);
    CHECK(flaw->factors[0] == Approx(by).epsilon(0.05));
  }
}

TEST_CASE("nothing is learnt from such readings: no name, and the model stays as it was") {
  std::vector<measure::Run> runs = of_the_model();
  scale(runs, 2, -1);
  const machine::MachineModel machine = testing::pm600_like();
  const Diagnosis d = diagnose(machine, runs);
  CHECK(d.verdict == Verdict::unknown);
  CHECK(d.effects.empty());
  REQUIRE(d.doubt);
  CHECK(d.doubt->effects.empty());
  CHECK(std::get<ChannelFlaw>(d.doubt->why).kind == ChannelFlaw::Kind::sign);
  REQUIRE(d.withheld);
  CHECK(std::get<ChannelFlaw>(*d.withheld).motors == std::vector<std::size_t>{2});
  CHECK(d.forces.parameters == physics::ForceModel(machine).parameters);
  CHECK(d.runs.size() == runs.size());
}

}  // namespace plumbline::diagnose
