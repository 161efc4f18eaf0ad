#include "diagnose/verdict.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

// The alternatives to one effect of one number on a plan, computed from the design: no reading is needed.
std::vector<std::string> alternatives_to(const std::string& effect, const std::string& key, double value,
                                         const std::vector<measure::Run>& runs, const VerdictOptions& options = {}) {
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  const CandidateSet candidates = make_candidate_set(machine, forces);
  const Workbench bench{machine, forces, runs, candidates};
  Model model;
  model.fit.values = candidates.unknowns.start();
  const int unknown = candidates.unknowns.find(effect, key);
  REQUIRE(unknown >= 0);
  model.fit.values[unknown] = value;
  model.problem = std::make_shared<const LinearProblem>(
      linearise(machine.rotation, runs, candidates, model.fit.values, testing::usual_noise()));
  Found found;
  found.pick = {&candidates.candidate(effect), 0, {0}, {unknown}};
  model.found = {found};
  return alternatives_of(bench, model, 0, options);
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST_CASE("a constant vertical force is no other than a mass, and a drag is") {
  const std::vector<std::string> names = alternatives_to("platform-mass", "mass_kg", 5, testing::wider_plan(60));
  CHECK(has(names, "counterbalance"));
  CHECK_FALSE(has(names, "joint-viscous"));
  CHECK_FALSE(has(names, "backlash"));
  CHECK_FALSE(has(names, "platform-mass"));
}

TEST_CASE("however alike two effects are, one that leaves more than noise of the other is no alternative") {
  VerdictOptions rough;
  rough.same_signature = 0.1;
  rough.told_apart_nats = 1e9;
  CHECK(has(alternatives_to("platform-mass", "mass_kg", 5, testing::wider_plan(60), rough), "payload"));
  rough.told_apart_nats = 20;
  const std::vector<std::string> names = alternatives_to("platform-mass", "mass_kg", 5, testing::wider_plan(60), rough);
  CHECK_FALSE(has(names, "payload"));
  CHECK(has(names, "counterbalance"));
}

TEST_CASE("whatever is within six nats of the strongest is not ruled out") {
  const machine::MachineModel machine = testing::pm600_like();
  const CandidateSet candidates = make_candidate_set(machine, physics::ForceModel(machine));
  Model model;
  Found found;
  found.pick.candidate = &candidates.candidate("level");
  found.log_odds = 40;
  for (const auto& [name, odds] : std::vector<std::pair<std::string, double>>{{"cable", 36}, {"inertia", 30}}) {
    Rival rival;
    rival.pick.candidate = &candidates.candidate(name);
    rival.log_odds = odds;
    rival.refitted = true;
    found.rivals.push_back(rival);
  }
  model.found = {found};
  const std::vector<NamedEffect> effects{{"level", {"counterbalance"}, {}, 40}};
  CHECK(confidence_set_of(model, effects, {}) == std::vector<std::string>{"level", "counterbalance", "cable"});
  VerdictOptions wide;
  wide.within_nats = 12;
  CHECK(has(confidence_set_of(model, effects, wide), "inertia"));
}

}  // namespace
}  // namespace plumbline::diagnose
