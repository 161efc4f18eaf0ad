#include "identify/plausible.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "base/mean_square.hpp"
#include "identify/identify.hpp"
#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

// A machine with an effect that its model lacks, all numbers of the key alike.
physics::ForceModel with(const char* effect, const char* key, int numbers, double value) {
  physics::ForceModel forces(pm600_like());
  const int first = forces.add(effect) + physics::effect_infos()[physics::effect_index(effect)].offset_of(key);
  for (int i = 0; i < numbers; ++i) forces.parameters[static_cast<std::size_t>(first + i)] = value;
  return forces;
}

Identification identified(const physics::ForceModel& forces, unsigned seed, double torque_noise = 0.05) {
  Random random(seed);
  return identify::identify(pm600_like(), measured(wider_plan(), forces, 0.5e-6, torque_noise, random));
}

// A machine as [uncertainty] says, and the fit to what it reads.
struct FittedToDrawn {
  machine::MachineModel machine;
  Unknowns unknowns;
  std::vector<measure::Run> runs;
  FitOptions options;
  Fit whole;
};

FittedToDrawn fitted_to_drawn(unsigned seed) {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  Random random(seed);
  const physics::ForceModel forces = unknowns.at(drawn(unknowns, random));
  const auto runs = measured(wider_plan(), forces, 0.5e-6, 0.05, random);
  FitOptions options;
  options.objective.huber = 0;
  return {machine, unknowns, runs, options, fit(machine.rotation, runs, unknowns, options)};
}

// Labels of the unknowns whose priors are refuted, if that is the objection.
std::vector<std::string> strained_in(const Identification& found) {
  const Stage* const stage = found.objected();
  std::vector<std::string> labels;
  if (stage == nullptr || stage->objection != Objection::strained) return labels;
  for (const Strain& strain : stage->plausible.strained) labels.push_back(stage->fit.unknowns[strain.unknown].label);
  return labels;
}

bool holds(const std::vector<std::string>& labels, std::string_view begin) {
  return std::any_of(labels.begin(), labels.end(), [&](const std::string& label) { return label.starts_with(begin); });
}

}  // namespace

TEST_CASE("nothing speaks against a machine that is as [uncertainty] says") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  for (unsigned seed = 1; seed < 5; ++seed) {
    Random random(seed);
    const physics::ForceModel forces = unknowns.at(drawn(unknowns, random));
    const auto runs = measured(wider_plan(), forces, 0.5e-6, 0.05, random);
    CHECK(identify::identify(machine, runs).objected() == nullptr);
  }
}

TEST_CASE("nothing speaks against a model that was right before") {
  CHECK(identified(physics::ForceModel(pm600_like()), 11).objected() == nullptr);
}

TEST_CASE("numbers beyond six sigma are an objection that knows which they are") {
  CHECK(holds(strained_in(identified(with("centre-of-mass", "offset_mm", 1, 30e-3), 21)), "centre of mass x"));
  const std::vector<std::string> friction = strained_in(identified(with("screw-coulomb", "force_N", 2, 90), 22));
  CHECK(holds(friction, "friction strut 1"));
  CHECK(holds(friction, "friction strut 2"));
  // with more noise other numbers, each within its prior, could stand in for a part of the tilt
  CHECK(holds(strained_in(identified(with("level", "tilt_mrad", 2, 3e-3), 23, 0.005)), "level tilt_mrad"));
}

TEST_CASE(
    "many numbers that are all further off than they should be are an objection, though none is beyond six sigma") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  Random random(31);
  Eigen::VectorXd far = unknowns.start();
  far += 2.6 * (drawn(unknowns, random) - far);
  const auto runs = measured(wider_plan(), unknowns.at(far), 0.05e-6, 0.005, random);
  Fit found = fit(machine.rotation, runs, unknowns);
  PlausibleOptions options;
  options.most_sigmas = 20;
  options.most_sigmas_all = 0.5;
  const Plausibility plausible = plausibility(machine.rotation, runs, found, {}, options);
  CHECK(plausible.strained.empty());
  CHECK(plausible.all_sigmas > 0.5);
  CHECK(plausible.all_strained);
  CHECK(objection(plausible, false, options) == Objection::all_strained);
  CHECK(objection(plausible, true, options) != Objection::all_strained);
}

TEST_CASE("what a pose left out is predicted to be is what a fit without it predicts") {
  auto [machine, unknowns, runs, options, whole] = fitted_to_drawn(41);
  const Plausibility plausible = plausibility(machine.rotation, runs, whole, options);

  options.known_noise = whole.noise;
  MeanSquare radial;
  for (std::size_t pose = 0; pose < 4; ++pose) {
    std::vector<measure::Run> others;
    std::vector<measure::Run> out;
    for (std::size_t i = 0; i < runs.size(); ++i) (i % 4 == pose ? out : others).push_back(runs[i]);
    const Fit found = fit(machine.rotation, others, unknowns, options);
    Objective objective(machine.rotation, out, Unknowns(found.forces()), options.objective);
    objective.set_noise(whole.noise);
    for (const RunEquations& run : objective.equations(Eigen::VectorXd(0))) radial.add(run.residual.head(run.samples));
  }
  CHECK(plausible.radial.readings == 8 * 90);
  CHECK(plausible.radial.after == Approx(radial.root()).epsilon(0.03));
  CHECK(plausible.radial.before > plausible.radial.after);
  CHECK(plausible.radial.doubt > 0.5e-6);
  CHECK(plausible.radial.doubt < 1e-6);
}

TEST_CASE("what leaving out a pose moves is what a fit without it finds elsewhere") {
  auto [machine, unknowns, runs, options, whole] = fitted_to_drawn(42);
  const Eigen::MatrixXd moved = moved_by_poses(machine.rotation, runs, whole, options.objective, 3);
  REQUIRE(moved.cols() == 4);
  options.known_noise = whole.noise;
  for (std::size_t pose = 0; pose < 4; ++pose) {
    std::vector<measure::Run> others;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (i % 4 != pose) others.push_back(runs[i]);
    }
    const Eigen::VectorXd found = fit(machine.rotation, others, unknowns, options).values - whole.values;
    const Eigen::VectorXd off = (moved.col(static_cast<Eigen::Index>(pose)) - found).cwiseQuotient(unknowns.scales());
    CHECK(off.norm() < 0.05 * found.cwiseQuotient(unknowns.scales()).norm());
  }
  CHECK(moved_by_poses(machine.rotation, runs, whole, options.objective, 5).cols() == 0);
}

TEST_CASE("the jackknife of a mean is its standard error") {
  // Leaving one of n readings out moves their mean by (mean - reading) / (n - 1).
  const Eigen::RowVectorXd readings = (Eigen::RowVectorXd(5) << 1, 2, 4, 7, 11).finished();
  const Eigen::MatrixXd moved = (readings.mean() - readings.array()) / 4;
  const double variance = (readings.array() - readings.mean()).square().sum() / 4;
  CHECK(jackknife(moved).squaredNorm() == Approx(variance / 5));
  CHECK(jackknife(moved.leftCols(1)).norm() == 0);
}

TEST_CASE("poses predicted worse are an objection beyond what the fit must expect, not within it") {
  PlausibleOptions options;
  Predicted predicted{0.5e-6, 1.2e-6, 0.7e-6, 100};
  CHECK_FALSE(predicted.worse(options, options.least_radial));
  predicted.after = 2e-6;
  CHECK(predicted.worse(options, options.least_radial));
  predicted.doubt = 0;
  predicted.after = 0.7e-6;
  CHECK(predicted.worse(options, options.least_radial));
  predicted.readings = 0;
  CHECK_FALSE(predicted.worse(options, options.least_radial));
}

TEST_CASE("a fit is borne out by circles that it did not see and by the tip together, by neither alone") {
  Plausibility plausible;
  plausible.radial = {2e-6, 1e-6, 0, 100};
  CHECK(plausible.radial.predicted() == Approx(0.75));
  CHECK(borne_out(plausible, 0.05));
  CHECK_FALSE(borne_out(plausible, 0.2));
  plausible.radial.after = 1.6e-6;
  CHECK_FALSE(borne_out(plausible, 0.05));
  plausible.radial = {};
  CHECK(plausible.radial.predicted() == 0);
  CHECK_FALSE(borne_out(plausible, 0));
}

TEST_CASE("a number beyond six sigma or poses predicted worse are an objection though a fit is borne out") {
  Plausibility plausible;
  CHECK_FALSE(objection(plausible, true));
  plausible.torque = {0.1, 0.5, 0, 100};
  CHECK(objection(plausible, true) == Objection::torque_worse);
  plausible.radial = {1e-6, 5e-6, 0, 100};
  CHECK(objection(plausible, true) == Objection::radial_worse);
  plausible.strained = {{0, 7}};
  CHECK(objection(plausible, true) == Objection::strained);
}

TEST_CASE("joints that a tracker saw may be far off, other numbers may not") {
  const machine::MachineModel machine = pm600_like();
  Fit found(geometry_unknowns(machine, physics::ForceModel(machine)));
  found.values = found.unknowns.start();
  found.covariance.setZero(found.values.size(), found.values.size());
  const auto joint = static_cast<Eigen::Index>(found.unknowns.find("joint-position", "base_um", 3));
  found.values[joint] += 7 * found.unknowns[static_cast<std::size_t>(joint)].sigma;
  PlausibleOptions options;
  CHECK(plausibility(machine.rotation, {}, found, {}, options).strained.size() == 1);
  options.joints_seen = true;
  CHECK(plausibility(machine.rotation, {}, found, {}, options).strained.empty());
  for (std::size_t i = 0; i < found.unknowns.size(); ++i) {
    if (is_geometry(found.unknowns[i])) continue;
    found.values[static_cast<Eigen::Index>(i)] += 7 * found.unknowns[i].sigma;
    break;
  }
  CHECK(plausibility(machine.rotation, {}, found, {}, options).strained.size() == 1);
}

TEST_CASE("with two poses none is left out") {
  const machine::MachineModel machine = pm600_like();
  Random random(51);
  const auto runs = measured(papers_plan(), physics::ForceModel(machine), 0.5e-6, 0.05, random);
  const Unknowns unknowns = nuisances(machine, physics::ForceModel(machine));
  CHECK(plausibility(machine.rotation, runs, fit(machine.rotation, runs, unknowns), {}).radial.readings == 0);
}
