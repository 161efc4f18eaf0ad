// Plans of circular tests: what they are chosen by, and that they tell what they say.
#include "identify/design.hpp"

#include <set>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "identify/fit.hpp"
#include "identify/plans.hpp"
#include "identify/unknowns/geometry.hpp"
#include "measure/planned_run.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

// One number each tells of one of two unknowns, or of their sum.
const std::vector<Eigen::MatrixXd> kSmall{(Eigen::Matrix2d() << 4, 0, 0, 0).finished(),
                                          (Eigen::Matrix2d() << 0, 0, 0, 1).finished(),
                                          (Eigen::Matrix2d() << 1, 1, 1, 1).finished()};

Unknowns two_unknowns() {
  Unknowns unknowns{physics::ForceModel(pm600_like())};
  unknowns.set_prior(unknowns.add("payload", "mass_kg", 0), 1);
  unknowns.set_prior(unknowns.add("platform-mass", "mass_kg", 0), 1);
  return unknowns;
}

}  // namespace

TEST_CASE("the criterion is the determinant of what is known of those asked for") {
  const Unknowns unknowns = two_unknowns();
  const Eigen::MatrixXd information = kSmall[0] + kSmall[2];  // with priors [6 1; 1 2]
  CHECK(d_optimal(unknowns, {0, 1})(information) == Approx(std::log(6 * 2 - 1)));
  // variance of the first: 2 / 11
  CHECK(d_optimal(unknowns, {0})(information) == Approx(std::log(11.0 / 2)));
}

TEST_CASE("a plan for what moves with the unknowns minds its mean variance alone") {
  const Unknowns unknowns = two_unknowns();
  const Eigen::MatrixXd information = kSmall[0] + kSmall[2];  // with priors [6 1; 1 2], its inverse [2 -1; -1 6] / 11
  const auto square = [](double a, double b) {
    return Eigen::MatrixXd(kUm * kUm * Eigen::Vector2d(a, b) * Eigen::RowVector2d(a, b));
  };
  const Eigen::MatrixXd sum = square(1, 1);  // um for each scale, 1 kg: 2 - 2 + 6
  const Eigen::MatrixXd first = square(3, 0);
  CHECK(v_optimal(unknowns, {sum})(information) == Approx(-std::log(6.0 / 11)));
  CHECK(v_optimal(unknowns, {first})(information) == Approx(-std::log(18.0 / 11)));
  CHECK(v_optimal(unknowns, {sum, first})(information) == Approx(-(std::log(6.0 / 11) + std::log(18.0 / 11)) / 2));
  const Eigen::MatrixXd nothing = Eigen::MatrixXd::Zero(2, 2);
  CHECK(design(kSmall, nothing, v_optimal(unknowns, {first}), {.runs = 1}).chosen[0] == 0);
  CHECK(design(kSmall, nothing, v_optimal(unknowns, {square(0, 1)}), {.runs = 1}).chosen[0] != 0);
}

TEST_CASE("a design takes what tells most, and exchanges what turned out worse") {
  const Unknowns unknowns = two_unknowns();
  const Eigen::MatrixXd nothing = Eigen::MatrixXd::Zero(2, 2);
  // by hand, with priors: det of two runs, 00 9, 01 10, 02 11, 11 3, 12 7, 22 5
  const Design two = design(kSmall, nothing, d_optimal(unknowns, {0, 1}), {.runs = 2});
  CHECK(std::set<std::size_t>(two.chosen.begin(), two.chosen.end()) == std::set<std::size_t>{0, 2});
  CHECK(two.criterion.back() == Approx(std::log(11)));
  CHECK(two.information.isApprox(kSmall[0] + kSmall[2]));
  // of the second unknown alone, runs of the first tell nothing
  CHECK(design(kSmall, nothing, d_optimal(unknowns, {1}), {.runs = 1}).chosen[0] == 1);
  // what was measured already counts
  CHECK(design(kSmall, 10 * kSmall[0], d_optimal(unknowns, {0, 1}), {.runs = 1}).chosen[0] != 0);
}

TEST_CASE("a design is never worse than the best of many drawn ones") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const Unknowns unknowns = two_unknowns();
  std::vector<Eigen::MatrixXd> candidates;
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector2d slope(normal(random), normal(random));
    candidates.emplace_back(slope * slope.transpose());
  }
  const Criterion criterion = d_optimal(unknowns, {0, 1});
  const double chosen = design(candidates, Eigen::MatrixXd::Zero(2, 2), criterion, {.runs = 4}).criterion.back();
  for (int draw = 0; draw < 2000; ++draw) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2, 2);
    for (int k = 0; k < 4; ++k) sum += candidates[random() % candidates.size()];
    CHECK(criterion(sum) <= chosen + 1e-9);
  }
}

TEST_CASE("a circle beside a singularity is within the limits, and the tip does not stand firm there") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  const measure::Run usual = circle_run({0, 100, -1008}, {-20, 0, 0});
  CHECK(measure::within_limits(machine, usual));
  CHECK(stands_firm(machine.rotation, forces, usual, 0.5e-3));
  CHECK_FALSE(stands_firm(machine.rotation, forces, usual, 0.05e-3));
  const measure::Run beside = circle_run({-110, -130, -860}, {12, -18, 0});
  CHECK(measure::within_limits(machine, beside));
  CHECK_FALSE(stands_firm(machine.rotation, forces, beside, 0.5e-3));
  measure::Run loaded = usual;
  loaded.payload_mass = 2000;
  CHECK_FALSE(stands_firm(machine.rotation, forces, loaded, 0.5e-3));
}

TEST_CASE("where the machine cannot stand at all it does not stand firm") {
  const machine::MachineModel machine = pm600_like();
  physics::ForceModel forces(machine);
  forces.parameters[static_cast<std::size_t>(forces.find("platform-gravity", "mass_kg"))] = 1e8;
  CHECK_FALSE(stands_firm(machine.rotation, forces, circle_run({0, 100, -1008}, {-20, 0, 0}), 1e9));
}

TEST_CASE("candidates keep the machine's limits, and follow from the seed alone") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  const std::vector<measure::Run> runs = candidate_runs(machine, {.payloads = {0, 20}, .most = 60, .seed = 3});
  REQUIRE(runs.size() == 60);
  bool ccw = false;
  bool cw = false;
  bool loaded = false;
  for (const measure::Run& run : runs) {
    CHECK(measure::within_limits(machine, run));
    CHECK(stands_firm(machine.rotation, forces, run, 0.5e-3));
    CHECK(run.samples() == 36);
    for (const Vector3<double>& v : {run.centre_W, run.tilt}) {
      for (const double x : v) CHECK_FALSE((x == 0 && std::signbit(x)));  // "-0" would stand in the plan
    }
    ccw = ccw || run.direction == measure::Direction::ccw;
    cw = cw || run.direction == measure::Direction::cw;
    loaded = loaded || run.payload_mass > 0;
  }
  CHECK((ccw && cw && loaded));
  const std::vector<measure::Run> again = candidate_runs(machine, {.payloads = {0, 20}, .most = 60, .seed = 3});
  CHECK(again[59].centre_W == runs[59].centre_W);
  CHECK(again[59].tilt == runs[59].tilt);
  CHECK(candidate_runs(machine, {.most = 60, .seed = 4})[59].centre_W != runs[59].centre_W);
  CHECK(candidate_runs(machine, {.radii = {0.9}, .most = 5}).empty());
}

TEST_CASE("a plan for the geometry tells more of it than as many circles of the paper's kind") {
  const machine::MachineModel machine = pm600_like();
  const Unknowns unknowns = geometry_unknowns(machine, physics::ForceModel(machine));
  std::vector<std::size_t> asked = unknowns.of_effect("joint-position");
  NoiseModel noise;
  noise.channels.fill({0.05});
  noise.channels[kRadial].sigma = 0.5e-6;
  const auto informations = [&](const std::vector<measure::Run>& runs) {
    std::vector<Eigen::MatrixXd> all;
    for (const measure::Run& run : runs) all.push_back(run_information(machine.rotation, run, unknowns, noise));
    return all;
  };
  const Criterion criterion = d_optimal(unknowns, asked);
  const std::vector<Eigen::MatrixXd> candidates =
      informations(candidate_runs(machine, {.samples = 30, .most = 60, .seed = 1}));
  const Design plan =
      design(candidates, Eigen::MatrixXd::Zero(candidates[0].rows(), candidates[0].cols()), criterion, {.runs = 8});
  Eigen::MatrixXd eight = Eigen::MatrixXd::Zero(candidates[0].rows(), candidates[0].cols());
  for (const Eigen::MatrixXd& one : informations(wider_plan(30))) eight += one;
  CHECK(plan.criterion.back() > criterion(eight) + 1);
  for (std::size_t i = 1; i < plan.criterion.size(); ++i) CHECK(plan.criterion[i] > plan.criterion[i - 1]);
}

TEST_CASE("the distance of an effect from another one is what the other leaves of it") {
  Unknowns unknowns = two_unknowns();
  unknowns.set_free(0);
  unknowns.set_free(1);
  const Eigen::MatrixXd information = kSmall[0] + kSmall[2];  // [5 1; 1 1]
  CHECK(noncentrality(unknowns, information, {0}, {1}) == Approx(4));
  CHECK(noncentrality(unknowns, information, {1}, {0}) == Approx(0.8));
  CHECK(separating(unknowns, {0}, {1})(information) == Approx(std::log(0.8)));
  CHECK(noncentrality(unknowns, kSmall[2], {0}, {1}) < 1e-6);
}
