#include "identify/identify.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

std::string code_of(const std::vector<measure::Run>& runs, const IdentifyOptions& options,
                    const machine::MachineModel& machine = pm600_like()) {
  try {
    identify::identify(machine, runs, options);
  } catch (const Refusal& refusal) {
    CHECK_FALSE(refusal.diagnostic().help.empty());
    return refusal.diagnostic().code;
  }
  return "";
}

}  // namespace

TEST_CASE("the joint fit brings the gap down to the noise") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  Random random(71);
  const auto runs = measured(wider_plan(), unknowns.at(drawn(unknowns, random)), 0.5e-6, 0.05, random);
  const Identification found = identify::identify(machine, runs);
  CHECK(found.converged());
  REQUIRE(found.stages.size() == 1);
  CHECK(found.before.radial_rms > 1.2e-6);
  CHECK(found.after.radial_rms < 0.55e-6);
  CHECK(found.after.torque_rms < 0.055);
  CHECK(found.after.radial_readings == 8 * 90);
}

TEST_CASE("circles at one height do not tell K1 from K2, and the program says so") {
  const machine::MachineModel machine = pm600_like();
  Random random(72);
  const auto runs = measured(papers_plan(), physics::ForceModel(machine), 0.5e-6, 0.05, random);
  const Identification found = identify::identify(machine, runs);
  const Observability& known = found.stages.front().observability;
  CHECK(known.measured_at == MeasuredAt::circles_at_one_height);
  const Unknowns& unknowns = found.stages.front().fit.unknowns;
  const auto compliance = std::find_if(known.confusions.begin(), known.confusions.end(), [&](const Confusion& c) {
    return unknowns[c.first].label == "K1" && unknowns[c.second].label == "K2";
  });
  REQUIRE(compliance != known.confusions.end());
  CHECK(compliance->weight == Approx(1.25).margin(0.15));  // m, about as long as the struts
  CHECK(compliance->value == Approx(compliance->weight * 0.01287e-6 + 0.00782e-6).epsilon(0.02));
}

TEST_CASE("the paper's two stages find masses and friction from torques, compliance from the bar") {
  const machine::MachineModel machine = pm600_like();
  physics::ForceModel truth(machine);
  const Unknowns torques = torque_unknowns(truth);
  Eigen::VectorXd values = torques.start();
  CHECK(values.size() == 1 + 1 + 6 + 1);
  values[0] = 25;
  values[1] = 18.5;
  values[4] = 140;
  const Unknowns compliances = compliance_unknowns(torques.at(values));
  Random random(73);
  const auto runs = measured(papers_plan(), compliances.at(1.05 * compliances.start()), 0.02e-6, 0.002, random);
  const Identification found = identify::identify(machine, runs, {.stages = Stages::paper});
  REQUIRE(found.stages.size() == 2);
  CHECK(found.stages[0].fit.values[0] == Approx(25).epsilon(0.02));
  CHECK(found.stages[0].fit.values[1] == Approx(18.5).epsilon(0.01));
  CHECK(found.stages[0].fit.values[4] == Approx(140).epsilon(0.01));
  const Eigen::VectorXd& K = found.stages[1].fit.values;
  CHECK(1.25 * K[0] + K[1] == Approx(1.05 * (1.25 * 0.01287e-6 + 0.00782e-6)).epsilon(0.005));
  CHECK(found.after.torque_mean_abs < 0.003);
}

TEST_CASE("a key named as free is fitted, without a prior") {
  const machine::MachineModel machine = pm600_like();
  Random random(74);
  const auto runs = measured(papers_plan(40), physics::ForceModel(machine), 0.5e-6, 0.05, random);
  const Identification found =
      identify::identify(machine, runs, {.free = {"backlash.width_um", "strut.compliance_um_N"}});
  const Unknowns& unknowns = found.stages.front().fit.unknowns;
  CHECK(unknowns.of_effect("backlash").size() == 6);
  CHECK(unknowns[static_cast<std::size_t>(unknowns.find("axial-elasticity", "compliance_um_N"))].free());
  CHECK(unknowns.size() == 55 + 6);
}

TEST_CASE("what cannot be identified is refused, with the way out") {
  const std::vector<measure::Run> plan = papers_plan(24);
  std::vector<measure::Run> bar_only = plan;
  std::vector<measure::Run> torque_only = plan;
  std::vector<measure::Run> neither = plan;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    for (auto& torque : bar_only[i].torque) torque.clear();
    torque_only[i].radial.clear();
    neither[i].radial.clear();
    for (auto& torque : neither[i].torque) torque.clear();
  }
  CHECK(code_of(neither, {}) == "identify-no-readings");
  CHECK(code_of(bar_only, {.stages = Stages::paper}) == "identify-no-readings");
  CHECK(code_of(torque_only, {.stages = Stages::paper}) == "identify-no-readings");
  CHECK(code_of(plan, {.free = {"strut.motor_mas_kg"}}) == "identify-unknown-key");
  machine::MachineModel exact = pm600_like();
  for (machine::ModelValue& value : exact.values) {
    if (value.table == "uncertainty") value.span = {};
  }
  CHECK(code_of(plan, {}, exact) == "identify-nothing-unknown");
}
