// The steps of a diagnosis that hand on what the tested parts below them find have no tests of their own, since each
// takes a whole search: stage (a fit and its noise), assessment (verdict and doubt), conclusion (names and numbers),
// held_values (what is held back), unexplained (what is described beside the base model). The first test here goes
// through assessment and conclusion to a name, the second through unexplained, the third to a machine that lacks
// nothing; ../blind scores all of them on many machines. What they decide by is in doubt_test.cpp, verdict_test.cpp and
// identify/held_test.cpp.
#include "diagnose/diagnose.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "identify/plans.hpp"
#include "machine/model_file.hpp"
#include "measure/thinning.hpp"

namespace plumbline::diagnose {
namespace {

const std::string kBlind = std::string(PLUMBLINE_SOURCE_DIR) + "/tests/blind/";

Diagnosis diagnosed(const std::string& name, const DiagnoseOptions& options = {}) {
  const machine::MachineModel machine = machine::read_model(kBlind + name + "/base.toml");
  const measure::Dataset data = measure::read_dataset(kBlind + name + "/data/dataset.toml");
  return diagnose(machine, data.runs, options);
}

TEST_CASE("a hidden effect is named, and the gap on poses left out closes") {
  const Diagnosis d = diagnosed("open-08");
  CHECK(d.verdict == Verdict::named);
  REQUIRE(d.effects.size() == 1);
  CHECK(d.effects[0].name == "joint-viscous");
  CHECK(d.confidence_set == std::vector<std::string>{"joint-viscous"});
  const NamedParameter& damping = d.effects[0].parameters.at(0);
  CHECK(std::abs(damping.values[0] - 20.6087) < 3 * damping.errors[0]);  // what was hidden
  CHECK(*d.held_out.after.torque < *d.held_out.before.torque);
  CHECK(*d.held_out.after.radial < 0.6e-6);
  // what is known of the machine then
  REQUIRE(d.posterior.states.size() == 1);
  const int place = d.posterior.unknowns.find("joint-viscous", "damping_Nms_rad");
  REQUIRE(place >= 0);
  CHECK(d.posterior.unknowns[static_cast<std::size_t>(place)].free());
  CHECK(d.posterior.states[0].mean[place] == Approx(damping.values[0]));
  CHECK(std::sqrt(d.posterior.states[0].covariance(place, place)) == Approx(damping.errors[0]));
  CHECK(d.posterior.unexplained < 0.3e-6);
  const auto out = std::count_if(d.runs.begin(), d.runs.end(), [](const RunGap& run) { return run.held_out; });
  CHECK(out >= 2);
  CHECK(out < 8);
}

TEST_CASE("what no effect explains is described, and the description closes the gap on poses left out") {
  const Diagnosis d = diagnosed("open-09");
  CHECK(d.verdict == Verdict::unknown);
  CHECK(d.effects.empty());
  REQUIRE(d.remainder.has_value());
  REQUIRE_FALSE(d.functions.empty());  // which the model has in place of the description's terms
  const auto& rows = d.forces.instances();
  CHECK(std::any_of(rows.begin(), rows.end(),
                    [](const physics::Instance& row) { return physics::effect_infos()[row.effect].description; }));
  CHECK(*d.fit.after.radial < 0.6 * *d.fit.before.radial);
  CHECK(*d.held_out.after.radial < 0.6 * *d.held_out.before.radial);
}

// A machine whose friction and play grow with the square of how far a strut is from its middle: in no catalogue.
TEST_CASE("what no catalogue has is learnt where poses left out confirm it, and the posterior knows how sure it is") {
  const machine::MachineModel machine = testing::pm600_like();
  physics::ForceModel hiding(machine);
  const auto first = static_cast<std::size_t>(hiding.add("generic"));
  for (std::size_t j = 0; j < 6; ++j) {
    hiding.parameters[first + physics::Generic::kDrive + j] = -60;
    hiding.parameters[first + physics::Generic::kLength + j] = 5e-6;
  }
  hiding.parameters[first + physics::Generic::kStrutPowers] = 2;
  hiding.parameters[first + physics::Generic::kStrutPowers + 2] = 1;
  testing::Random random(19);
  DiagnoseOptions options;
  options.search.threshold.draws = 2000;
  const Diagnosis d =
      diagnose(machine, testing::measured(testing::wider_plan(120), hiding, 0.5e-6, 0.05, random), options);
  REQUIRE(d.verdict == Verdict::unknown);
  REQUIRE_FALSE(d.withheld);
  REQUIRE_FALSE(d.functions.empty());
  CHECK(*d.held_out.after.torque < 0.055);
  CHECK(*d.held_out.after.torque < 0.7 * *d.held_out.before.torque);
  CHECK(d.functions[0].log_odds > 8);
  CHECK(d.functions[0].left_out > 3);
  const auto is_learnt = [](const auto& unknown) {
    return unknown.effect == physics::Residual::name || unknown.effect == physics::Generic::name;
  };
  CHECK(std::any_of(d.posterior.unknowns.begin(), d.posterior.unknowns.end(), is_learnt));
  REQUIRE(d.posterior.states[0].moved.rows() == d.posterior.states[0].mean.size());
  CHECK(d.posterior.states[0].moved.norm() > 0);
  for (std::size_t i = 0; i < d.posterior.unknowns.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    CHECK(d.posterior.states[0].covariance(k, k) > 0);
    CHECK(d.posterior.states[0].covariance(k, k) <= 1.0001 * std::pow(d.posterior.unknowns[i].sigma, 2));
    if (is_learnt(d.posterior.unknowns[i])) CHECK(d.posterior.states[0].moved.row(k).isZero(0));
  }
}

// No key of one run is refuted by the others where all have the same fault.
TEST_CASE("with bar_mm wrong in all runs no model is given that moves the tip by millimetres") {
  const machine::MachineModel machine = machine::read_model(kBlind + "open-08/base.toml");
  measure::Dataset data = measure::read_dataset(kBlind + "open-08/data/dataset.toml");
  for (measure::Run& run : data.runs) run.bar = run.bar.value() + 10e-3;
  const Diagnosis d = diagnose(machine, data.runs);
  REQUIRE(d.withheld);
  CHECK(d.functions.empty());
}

TEST_CASE("a diagnosis is the same each time") {
  DiagnoseOptions options;
  options.search.threshold.draws = 2000;
  const Diagnosis one = diagnosed("open-03", options);
  const Diagnosis two = diagnosed("open-03", options);
  CHECK(one.verdict == Verdict::nothing_missing);
  CHECK(one.effects.empty());
  CHECK(one.threshold == two.threshold);
  CHECK(one.fit.after.radial == two.fit.after.radial);
  CHECK(one.threshold > 5);
  CHECK(one.threshold < 20);
}

TEST_CASE("what is left out of the catalogue must be in it") {
  DiagnoseOptions options;
  options.candidates.without = {"back-lash"};
  CHECK_THROWS_WITH(diagnosed("open-03", options), Catch::Contains("no effect is called back-lash"));
}

TEST_CASE("without a reading there is nothing to diagnose") {
  const machine::MachineModel machine = machine::read_model(kBlind + "open-03/base.toml");
  CHECK_THROWS_WITH(diagnose(machine, std::vector<measure::Run>(2)), Catch::Contains("has a reading"));
}

struct Hidden {
  const char* effect;
  const char* key;
  int index;
  double value;  // SI
};

// A machine that hides it, measured with so many samples a turn.
Diagnosis diagnosed(const Hidden& hidden, std::size_t samples) {
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  const CandidateSet candidates = make_candidate_set(machine, forces);
  Eigen::VectorXd values = candidates.unknowns.start();
  if (*hidden.effect != 0) values[candidates.unknowns.find(hidden.effect, hidden.key, hidden.index)] = hidden.value;
  testing::Random random(17);
  const measure::Thinned thinned = measure::fit_runs(
      machine, testing::measured(testing::wider_plan(samples), candidates.unknowns.at(values), 0.5e-6, 0.05, random));
  CHECK(thinned.thinning.thinned == (samples < 720 ? 0 : thinned.runs.size()));
  DiagnoseOptions options;
  options.search.threshold.draws = 2000;
  return diagnose(machine, thinned.runs, options);
}

TEST_CASE("long records have the verdict of short ones") {
  const auto hidden =
      GENERATE(Hidden{"", "", -1, 0}, Hidden{"backlash", "width_um", 2, 5e-6},
               Hidden{"cyclic", "amplitude_um", 1, 3e-6}, Hidden{"lead-error", "error_um_m", 3, 4e-4},
               Hidden{"joint-clearance", "width_um", -1, 40e-6}, Hidden{"load-friction", "mu", -1, 0.03});
  CAPTURE(hidden.effect);
  const Diagnosis few = diagnosed(hidden, 120);
  const Diagnosis many = diagnosed(hidden, 3600);
  if (*hidden.effect == 0) {
    CHECK(few.verdict == Verdict::nothing_missing);
    CHECK(many.verdict == Verdict::nothing_missing);
    return;
  }
  CHECK(few.confidence_set == std::vector<std::string>{hidden.effect});
  CHECK(many.confidence_set == few.confidence_set);
  CHECK(many.verdict == Verdict::named);
}

TEST_CASE("a contact that gives way at its balls is suspected and not named") {
  const double um_at_kN = GENERATE(15e-6, -15e-6);
  const Diagnosis d = diagnosed(Hidden{"contact-compliance", "um_at_kN", -1, um_at_kN}, 360);
  CHECK(d.verdict == Verdict::unknown);
  CHECK(d.effects.empty());
  REQUIRE(d.doubt);
  CHECK(d.doubt->effects == std::vector<std::string>{"contact-compliance"});
  REQUIRE(std::holds_alternative<Suspected>(d.doubt->why));
  CHECK_FALSE(d.withheld);
  CHECK(*d.fit.after.radial < 0.7 * *d.fit.before.radial);  // it is learnt all the same
}

}  // namespace
}  // namespace plumbline::diagnose
