#include "diagnose/evidence/threshold.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

namespace plumbline::diagnose {
namespace {

// Effects of one number each that may have either sign.
CandidateSet shelf_of(int effects) {
  const physics::ForceModel forces(testing::pm600_like());
  CandidateSet candidates{identify::Unknowns(forces), 0, {}, {}};
  for (int i = 0; i < effects; ++i) {
    Column column{"effect", "size"};
    column.lower = -std::numeric_limits<double>::infinity();
    column.upper = std::numeric_limits<double>::infinity();
    candidates.columns.push_back(column);
    ActingMode mode;
    mode.column_groups = {{i}};
    candidates.all.push_back({"effect", false, {mode}});
  }
  return candidates;
}

ThresholdOptions certain_noise() {
  ThresholdOptions options;
  options.noise_uncertainty = 0;
  return options;
}

// max over tau of [z^2 tau^2 / (1 + tau^2) - log(1 + tau^2)] / 2 = (z^2 - 1 - log z^2) / 2
double of_deviation(double z) { return 0.5 * (z * z - 1 - std::log(z * z)); }

TEST_CASE("the threshold of one number is the quantile of a normal deviate") {
  const Eigen::MatrixXd reduced = Eigen::MatrixXd::Identity(2, 2) * 49;
  // |z| > 2.968 in 0.3 % of draws
  CHECK(threshold(reduced, shelf_of(1), {}, certain_noise()).log_odds == Approx(of_deviation(2.968)).margin(0.25));
  ThresholdOptions often = certain_noise();
  often.false_alarms = 0.05;
  CHECK(threshold(reduced, shelf_of(1), {}, often).log_odds == Approx(of_deviation(1.96)).margin(0.12));
}

TEST_CASE("the more effects there are, the more the best of them reaches by chance") {
  const double one = threshold(Eigen::MatrixXd::Identity(2, 2), shelf_of(1), {}, certain_noise()).log_odds;
  const double twenty = threshold(Eigen::MatrixXd::Identity(21, 21), shelf_of(20), {}, certain_noise()).log_odds;
  // |z| > 3.789 in 0.3 % / 20
  CHECK(twenty == Approx(of_deviation(3.789)).margin(0.5));
  CHECK(twenty > one + 2);
  // effects that look all alike are one
  const Eigen::MatrixXd alike = Eigen::MatrixXd::Ones(21, 21);
  CHECK(threshold(alike, shelf_of(20), {}, certain_noise()).log_odds == Approx(one).margin(0.25));
}

TEST_CASE("noise that is less well known asks for more") {
  const Eigen::MatrixXd reduced = Eigen::MatrixXd::Identity(2, 2);
  ThresholdOptions unsure = certain_noise();
  unsure.noise_uncertainty = 0.3;
  CHECK(threshold(reduced, shelf_of(1), {}, unsure).log_odds >
        threshold(reduced, shelf_of(1), {}, certain_noise()).log_odds + 0.5);
}

TEST_CASE("a threshold is the same for the same seed") {
  ThresholdOptions options = certain_noise();
  options.draws = 2000;
  const Eigen::MatrixXd reduced = Eigen::MatrixXd::Identity(4, 4);
  const double one = threshold(reduced, shelf_of(3), {}, options).log_odds;
  CHECK(threshold(reduced, shelf_of(3), {}, options).log_odds == one);
  options.seed = 2;
  CHECK(threshold(reduced, shelf_of(3), {}, options).log_odds != one);
}

}  // namespace
}  // namespace plumbline::diagnose
