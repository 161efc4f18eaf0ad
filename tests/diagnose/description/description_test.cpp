// term_columns and waves have no tests of their own: a column is right if what it describes comes out of readings that
// a machine with that term makes. The first test holds the products of term_columns so, the second waves, the third
// that neither finds anything in noise.
#include "diagnose/description/description.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "diagnose/search/refit.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"
#include "physics/effects/generic.hpp"

namespace plumbline::diagnose {
namespace {

using physics::Generic;

// What is left of readings of a machine beside a model without what it hides, nuisances fitted to nothing.
Description description_of(const physics::ForceModel& hiding, std::uint64_t seed) {
  testing::Random random(seed);
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  const std::vector<measure::Run> runs = testing::measured(testing::wider_plan(60), hiding, 0.5e-6, 0.05, random);
  const CandidateSet candidates = make_candidate_set(machine, forces);
  const Workbench bench{machine, forces, runs, candidates};
  const identify::NoiseModel noise = testing::usual_noise(0.6);
  const Eigen::VectorXd start = candidates.unknowns.start();
  const LinearProblem problem = linearise(machine.rotation, runs, candidates, start, noise);
  return describe(bench, forces, problem, marginalised_by(candidates, {}, start), noise);
}

TEST_CASE("a product that acts on one strut is described as that product, with its size") {
  physics::ForceModel forces(testing::pm600_like());
  const auto first = static_cast<std::size_t>(forces.add("generic"));
  forces.parameters[first + Generic::kLength + 4] = 4e-6;  // m x s on strut 5
  forces.parameters[first + Generic::kStrutPowers + 2] = 1;
  const Description found = description_of(forces, 8);
  REQUIRE_FALSE(found.terms.empty());
  const Term& term = found.terms.front();
  CHECK(term.channel == Term::Channel::length);
  CHECK(term.part == 4);
  CHECK(term.strut_powers == std::array<int, 8>{0, 0, 1, 0, 0, 0, 0, 0});
  CHECK(term.shared_powers == std::array<int, 6>{});
  CHECK(found.log_odds > 6);
  CHECK(found.gain > 60);
  // what is written into the model says the same
  const std::vector<double> parameters = generic_parameters(term);
  CHECK(parameters[Generic::kLength + 4] == Approx(4e-6).epsilon(0.15));
  CHECK(parameters[Generic::kLength + 3] == 0);
}

TEST_CASE("a wave in the length of one strut is described as that wave, with its pitch and its size") {
  physics::ForceModel forces(testing::pm600_like());
  const auto first = static_cast<std::size_t>(forces.add("generic"));
  forces.parameters[first + Generic::kLength + 4] = 4e-6;
  forces.parameters[first + Generic::kPitch] = 0.05;
  forces.parameters[first + Generic::kPhase] = 1;
  const Description found = description_of(forces, 10);
  REQUIRE_FALSE(found.terms.empty());
  const Term& term = found.terms.front();
  CHECK(term.channel == Term::Channel::length);
  CHECK(term.part == 4);
  CHECK(1 / term.pitch == Approx(20).margin(1));  // cycles per metre are tried one by one
  CHECK(std::hypot(term.cosine, term.sine) == Approx(4e-6).epsilon(0.2));
  CHECK(found.log_odds > 6);
}

TEST_CASE("noise is not described") {
  const Description found = description_of(physics::ForceModel(testing::pm600_like()), 9);
  CHECK(found.terms.empty());
  CHECK(found.gain == 0);
  CHECK(found.log_odds < 6);
  CHECK(found.tried > 1000);
}

TEST_CASE("a wave in the length of a strut has amplitude and phase") {
  Term term;
  term.channel = Term::Channel::length;
  term.part = 4;
  term.pitch = 7e-3;
  term.cosine = 3e-6;
  term.sine = 4e-6;
  const std::vector<double> parameters = generic_parameters(term);
  CHECK(parameters[Generic::kLength + 4] == Approx(5e-6));
  CHECK(parameters[Generic::kPitch] == 7e-3);
  // cosine cos x - sine sin x = size cos(x + phase)
  CHECK(parameters[Generic::kPhase] == Approx(std::atan2(4, 3)));
}

}  // namespace
}  // namespace plumbline::diagnose
