// That the places and rivals are those of the conclusion, diagnose_test.cpp sees.
#include "diagnose/posterior.hpp"

#include <catch2/catch.hpp>

#include "diagnose/diagnose.hpp"
#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

// A machine whose joints and offsets are so many times as far off as its owner says.
diagnose::Diagnosis diagnosed(double times) {
  const machine::MachineModel machine = pm600_like();
  const identify::Unknowns unknowns = identify::nuisances(machine, physics::ForceModel(machine));
  Random random(3);
  const Eigen::VectorXd values = unknowns.start() + times * (drawn(unknowns, random) - unknowns.start());
  diagnose::DiagnoseOptions options;
  options.search.threshold.draws = 500;
  return diagnose::diagnose(machine, measured(wider_plan(90), unknowns.at(values), 0.5e-6, 0.05, random), options);
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
