// part and rows have no tests of their own: what a row adds to a machine that is measured must come out of the columns
// of its shape, in the first test smooth functions, then formulas and waves.
#include "diagnose/residual_model/learner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "diagnose/residual_model/rows.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"
#include "physics/effects/generic.hpp"
#include "physics/effects/residual.hpp"

namespace plumbline::diagnose {
namespace {

using physics::Generic;
using physics::Residual;

// What is learnt of readings of a machine beside a model without what it hides.
Learner learnt(const physics::ForceModel& hiding, std::uint64_t seed, const ResidualOptions& options = {}) {
  testing::Random random(seed);
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  const std::vector<measure::Run> runs = testing::measured(testing::wider_plan(60), hiding, 0.5e-6, 0.05, random);
  const CandidateSet candidates = make_candidate_set(machine, forces);
  const Workbench bench{machine, forces, runs, candidates};
  const identify::NoiseModel noise = testing::usual_noise(0.6);
  const Eigen::VectorXd start = candidates.unknowns.start();
  const LinearProblem problem = linearise(machine.rotation, runs, candidates, start, noise);
  // a learner keeps what it needs of the bench
  Learner learner(bench, forces, problem, marginalised_by(candidates, {}, start), noise, {}, options);
  learner.learn();
  return learner;
}

// A row of `residual` on strut 3, a function of its length.
physics::ForceModel with_function(const std::vector<double>& weights_um) {
  physics::ForceModel forces(testing::pm600_like());
  const auto first = static_cast<std::size_t>(forces.add("residual"));
  for (std::size_t k = 0; k < weights_um.size(); ++k)
    forces.parameters[first + Residual::kLength + k] = weights_um[k] * 1e-6;
  forces.parameters[first + Residual::kPart] = 3;
  forces.parameters[first + Residual::kCoordinate] = 7;
  forces.parameters[first + Residual::kHalfWidth] = 2;
  return forces;
}

// Of the weights of a function at x = (coordinate - middle) / half width.
Eigen::RowVectorXd functions_at(double x, Eigen::Index count) {
  Eigen::RowVectorXd values(count);
  for (Eigen::Index k = 0; k < count; ++k)
    values[k] = std::sin(std::numbers::pi * static_cast<double>(k + 1) * (x + 2) / 4);
  return values;
}

TEST_CASE("a drawn function of a strut's length is found on that strut, within its stated uncertainty") {
  const std::vector<double> drawn{0, 6, 0, -5, 3, 0, 4};
  const Learner learner = learnt(with_function(drawn), 31);
  REQUIRE(learner.components().size() == 1);
  const Component& found = learner.components().front();
  CHECK(found.shape.channel == Term::Channel::length);
  CHECK(found.shape.coordinates == std::vector<int>{7});
  CHECK(found.parts == std::vector<int>{2});
  CHECK(found.left_out > 3);
  const Eigen::Index count = found.weights.size();
  const Eigen::MatrixXd covariance =
      found.sigmas.asDiagonal() * learner.covariance().bottomRightCorner(count, count) * found.sigmas.asDiagonal();
  const double lower = found.region.lower[2][0];
  const double upper = found.region.upper[2][0];
  // beside the mean over the region, which the strut's offset may have as well
  constexpr int kPoints = 21;
  Eigen::MatrixXd functions(kPoints, count);
  Eigen::VectorXd truth(kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double coordinate = lower + (upper - lower) * i / (kPoints - 1);
    functions.row(i) = functions_at((coordinate - found.region.middle[0]) / found.region.half_width[0], count);
    const Eigen::RowVectorXd of_drawn = functions_at(std::clamp(coordinate / 2, -1.0, 1.0), 7);
    truth[i] = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k) truth[i] += drawn[k] * 1e-6 * of_drawn[static_cast<Eigen::Index>(k)];
  }
  functions.rowwise() -= functions.colwise().mean().eval();
  truth.array() -= truth.mean();
  CHECK(truth.cwiseAbs().maxCoeff() > 4e-6);
  for (int i = 0; i < kPoints; ++i) {
    const double sigma = std::sqrt(functions.row(i).dot(covariance * functions.row(i).transpose()));
    CHECK(std::abs(functions.row(i).dot(found.weights) - truth[i]) < 3.5 * sigma);
    CHECK(sigma < 4e-6);
  }
}

TEST_CASE("nothing is learnt of noise") {
  const Learner learner = learnt(physics::ForceModel(testing::pm600_like()), 32);
  CHECK(learner.components().empty());
}

TEST_CASE("a component that nothing asks for shrinks away") {
  const Learner found = learnt(with_function({0, 6, 0, -5, 3, 0, 4}), 31);
  REQUIRE_FALSE(found.components().empty());
  testing::Random random(33);
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  const std::vector<measure::Run> runs = testing::measured(testing::wider_plan(60), forces, 0.5e-6, 0.05, random);
  const CandidateSet candidates = make_candidate_set(machine, forces);
  const Eigen::VectorXd start = candidates.unknowns.start();
  const identify::NoiseModel noise = testing::usual_noise(0.6);
  const LinearProblem problem = linearise(machine.rotation, runs, candidates, start, noise);
  Learner learner({machine, forces, runs, candidates}, forces, problem, marginalised_by(candidates, {}, start), noise,
                  {}, {});
  Component idle = found.components().front();
  idle.weights.setZero();
  learner.take(idle);
  CHECK_FALSE(learner.learn());
  CHECK(learner.components().empty());
}

TEST_CASE("where a formula says it as well, the formula is named") {
  physics::ForceModel forces(testing::pm600_like());
  const auto first = static_cast<std::size_t>(forces.add("generic"));
  for (std::size_t j = 0; j < 6; ++j) forces.parameters[first + Generic::kLength + j] = 25e-6;
  forces.parameters[first + Generic::kStrutPowers + 3] = 1;  // t |t|
  forces.parameters[first + Generic::kStrutPowers + 4] = 1;
  const Learner learner = learnt(forces, 34);
  REQUIRE(learner.components().size() == 1);
  const Component& found = learner.components().front();
  CHECK(found.shape.strut_powers == std::array<int, 8>{0, 0, 0, 1, 1, 0, 0, 0});
  CHECK_FALSE(found.shape.is_smooth());
  CHECK(found.parts == std::vector<int>{-1});
  CHECK(found.weights[0] == Approx(25e-6).epsilon(0.1));
}

TEST_CASE("waves of one pitch on all struts are one component, and the model has a row for each strut") {
  physics::ForceModel forces(testing::pm600_like());
  for (std::size_t j = 0; j < 6; ++j) {
    const auto first = static_cast<std::size_t>(forces.add("generic"));
    forces.parameters[first + Generic::kLength + j] = 0.8e-6;
    forces.parameters[first + Generic::kPitch] = 0.0132;
    forces.parameters[first + Generic::kPhase] = static_cast<double>(j);
  }
  const Learner learner = learnt(forces, 35);
  REQUIRE(learner.components().size() == 1);
  const Component& found = learner.components().front();
  CHECK(1 / found.shape.pitch == Approx(1 / 0.0132).margin(0.2));
  CHECK(found.parts.size() == 6);
  physics::ForceModel written(testing::pm600_like());
  const std::vector<RowNumber> numbers = add_rows(found, written);
  CHECK(written.instances_of(physics::effect_index("generic")).size() == 6);
  REQUIRE(numbers.size() == 12);
  for (std::size_t j = 0; j < 6; ++j) {
    const auto first = static_cast<std::size_t>(written.instances_of(physics::effect_index("generic"))[j]);
    CHECK(written.parameters[first + Generic::kLength + j] == Approx(0.8e-6).epsilon(0.25));
    CHECK(numbers[2 * j].key == "length_um");
    CHECK(numbers[2 * j].index == static_cast<int>(j));
    CHECK(numbers[2 * j].row == static_cast<int>(j));
  }
}

TEST_CASE("a component that is larger than so many times all together is not added") {
  const physics::ForceModel hiding = with_function({0, 6, 0, -5, 3, 0, 4});
  ResidualOptions options;
  options.most_over_all = 1.01;  // one alone is all
  CHECK(learnt(hiding, 31, options).components().size() == 1);
  options.most_over_all = 0.99;
  CHECK(learnt(hiding, 31, options).components().empty());
}

TEST_CASE("the spread that is likeliest is that of the numbers, and noise has none") {
  const Eigen::MatrixXd gram = 100 * Eigen::MatrixXd::Identity(400, 400);
  testing::Random random(36);
  std::normal_distribution<double> normal;
  Eigen::VectorXd pull(400);
  for (double& b : pull) b = 100 * 2 * normal(random) + 10 * normal(random);  // A w + noise, w of spread 2
  const Spread spread = best_spread(gram, pull);
  CHECK(spread.tau == Approx(2).epsilon(0.1));
  CHECK(spread.log_bayes > 1000);
  for (double& b : pull) b = 10 * normal(random);
  CHECK(best_spread(gram, pull).log_bayes < 3);
}

}  // namespace
}  // namespace plumbline::diagnose
