#include "identify/posterior/posterior.hpp"

#include <catch2/catch.hpp>

#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

TEST_CASE("a model of which nothing was learnt is known as its owner states it") {
  const machine::MachineModel model = pm600_like();
  const Posterior prior = prior_of(model);
  CHECK_FALSE(prior.from_data);
  REQUIRE(prior.states.size() == 1);
  const Eigen::VectorXd scales = prior.unknowns.scales();
  CHECK(prior.states.front().mean == prior.unknowns.start());
  CHECK((prior.states.front().doubt() - Eigen::MatrixXd(scales.cwiseAbs2().asDiagonal())).norm() < 1e-12);
}

TEST_CASE("what was learnt is kept as it was before a shift was held back") {
  const machine::MachineModel model = pm600_like();
  const physics::ForceModel forces(model);
  Random random(7);
  const Unknowns unknowns = nuisances(model, forces);
  const auto runs = measured(wider_plan(36), unknowns.at(drawn(unknowns, random)), 0.5e-6, 0.05, random);
  const Identification found = identify::identify(model, runs);
  const Posterior posterior = posterior_of(model, found);
  const Stage& stage = found.stages.front();
  REQUIRE(posterior.states.size() == 1);
  const PosteriorState& state = posterior.states.front();
  CHECK(posterior.unknowns.size() == unknowns.size());
  CHECK(state.mean == stage.held->found);
  CHECK((state.doubt() - doubt_of(stage.fit, stage.plausible)).norm() <= 1e-9 * state.doubt().norm());
  CHECK(posterior.noise.radial == Approx(0.5e-6).epsilon(0.4));
}

TEST_CASE("what two stages did not fit is as its owner states it") {
  const machine::MachineModel model = pm600_like();
  Random random(9);
  const auto runs = measured(wider_plan(36), physics::ForceModel(model), 0.5e-6, 0.05, random);
  IdentifyOptions options;
  options.stages = Stages::paper;
  const Posterior posterior = posterior_of(model, identify::identify(model, runs, options));
  const int joint = posterior.unknowns.find("joint-position", "base_um", 4);
  REQUIRE(joint >= 0);
  const Eigen::MatrixXd doubt = posterior.states.front().doubt();
  CHECK(doubt.rows() == static_cast<Eigen::Index>(posterior.unknowns.size()));
  CHECK(std::sqrt(doubt(joint, joint)) == Approx(posterior.unknowns[static_cast<std::size_t>(joint)].sigma));
  CHECK(posterior.unknowns.find("axial-elasticity", "compliance_um_N") >= 0);
}
