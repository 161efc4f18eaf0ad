// That the places and rivals are those of the conclusion, diagnose_test.cpp sees.
#include "diagnose/posterior.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "diagnose/diagnose.hpp"
#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

diagnose::Diagnosis diagnosed(const std::vector<measure::Run>& plan, const identify::Unknowns& unknowns,
                              const Eigen::VectorXd& values, Random& random) {
  diagnose::DiagnoseOptions options;
  options.search.threshold.draws = 500;
  return diagnose::diagnose(pm600_like(), measured(plan, unknowns.at(values), 0.5e-6, 0.05, random), options);
}

// Twelve poses, which tell where a strut's length is off.
std::vector<measure::Run> widest_plan() {
  std::vector<measure::Run> runs = wider_plan(45);
  for (const Vector3<double>& there : {Vector3<double>(60, -50, 40), Vector3<double>(-50, 60, -30)}) {
    for (measure::Run run : wider_plan(45)) {
      const Vector3<double> centre = 1e3 * run.centre_W + there;
      const Vector3<double> tilt = run.tilt.cwiseProduct(Vector3<double>(-1, -0.6, 0)) / kDeg;
      runs.push_back(circle_run(centre, tilt, run.direction, 45));
    }
  }
  return runs;
}

identify::Unknowns known_of_pm600() {
  const machine::MachineModel machine = pm600_like();
  return identify::nuisances(machine, physics::ForceModel(machine));
}

// A machine whose joints and offsets are so many times as far off as its owner says.
diagnose::Diagnosis diagnosed(double times) {
  const identify::Unknowns unknowns = known_of_pm600();
  Random random(3);
  const Eigen::VectorXd values = unknowns.start() + times * (drawn(unknowns, random) - unknowns.start());
  return diagnosed(wider_plan(90), unknowns, values, random);
}

}  // namespace

TEST_CASE("a diagnosis is as unsure as its poses disagree, and where priors are too narrow") {
  const identify::PosteriorState usual = diagnosed(1).posterior.states.at(0);
  CHECK(usual.widening < 1.5);
  REQUIRE(usual.moved.cols() == 3);  // of four poses one is held out
  CHECK(usual.moved.rows() == usual.mean.size());
  const Eigen::VectorXd by_poses = usual.moved.rowwise().squaredNorm();
  const Eigen::VectorXd by_noise = usual.covariance.diagonal();
  // a pose of three tells about as much as the noise and the priors leave open
  const double ratio = by_poses.cwiseQuotient(by_noise.cwiseMax(1e-30)).mean();
  CHECK(ratio > 0.05);
  CHECK(ratio < 5);
  const identify::PosteriorState strained = diagnosed(2).posterior.states.at(0);
  CHECK(strained.widening > 2);
  CHECK(strained.widening < 8);  // 2 squared, by chance
}

TEST_CASE("what was named strains no prior, though its owner states one") {
  const identify::Unknowns unknowns = known_of_pm600();
  for (const double off : {400e-6, -250e-6}) {
    Random random(7);
    Eigen::VectorXd values = drawn(unknowns, random);
    values[unknowns.find("strut-offset", "length_um", 2)] += off;
    values[unknowns.find("strut-offset", "length_um", 4)] -= off / 2;
    const diagnose::Diagnosis found = diagnosed(widest_plan(), unknowns, values, random);
    REQUIRE(found.effects.size() == 1);
    CHECK(found.effects.front().name == "strut-offset");
    CHECK_FALSE(found.withheld);
    CHECK(found.posterior.states.at(0).widening < 2);
  }
}
