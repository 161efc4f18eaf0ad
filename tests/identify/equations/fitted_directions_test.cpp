#include "identify/equations/fitted_directions.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::identify;

namespace {

// Two unknowns; torques of strut 1 read the first alone, torques of strut 2 both alike, all with noise of one.
std::vector<RunEquations> two_channels() {
  RunEquations run;
  run.channels = {1, 2};
  run.samples = 4;
  run.residual = Eigen::VectorXd::Zero(8);
  run.slopes = SlopeRows::Zero(8, 2);
  run.slopes.topRows(4).col(0).setOnes();
  run.slopes.bottomRows(4).setOnes();
  return {run};
}

// All that is known: the readings (information [8 4; 4 4]) and a prior of the second unknown.
FittedUnknowns fitted(double prior) {
  FittedUnknowns of;
  of.precision = Eigen::Matrix2d{{8, 4}, {4, 4 + prior}};
  of.scales = Eigen::Vector2d::Ones();
  return of;
}

}  // namespace

TEST_CASE("the degrees of freedom that channels take are those of all unknowns that readings tell") {
  // without priors trace(P^-1 (I1 + I2)) = 2; of these channel 1 has trace(P^-1 diag(4, 0)) = 4 x 4 / 16 = 1
  const FittedDirections one = fitted_directions(two_channels(), 1, fitted(0));
  const FittedDirections two = fitted_directions(two_channels(), 2, fitted(0));
  CHECK(one.degrees == Approx(1));
  CHECK(two.degrees == Approx(1));
  CHECK(one.share.size() == 1);
  CHECK(one.share[0] == Approx(1));
}

TEST_CASE("what a prior tells is taken from no channel") {
  // P = [8 4; 4 8], P^-1 = [8 -4; -4 8] / 48: channel 1 takes 4 x 8 / 48, channel 2 (4 everywhere) 4 x (8 + 8 - 8) / 48
  CHECK(fitted_directions(two_channels(), 1, fitted(4)).degrees == Approx(2 / 3.0));
  CHECK(fitted_directions(two_channels(), 2, fitted(4)).degrees == Approx(2 / 3.0));
}

TEST_CASE("a direction is a change of the unknowns in standard deviations of what all leave open") {
  const FittedDirections one = fitted_directions(two_channels(), 1, fitted(0));
  REQUIRE(one.changes.cols() == 1);
  // channel 1 tells the first unknown; changes of it have precision one: d' P d = 1
  const Eigen::Vector2d d = one.changes.col(0);
  CHECK(d.dot(fitted(0).precision * d) == Approx(1));
  CHECK(4 * d[0] * d[0] == Approx(one.share[0]));
}

TEST_CASE("a channel that was not measured tells no direction") {
  const FittedDirections none = fitted_directions(two_channels(), 5, fitted(0));
  CHECK(none.degrees == Approx(0).margin(1e-12));
  CHECK(none.share.size() == 0);
  CHECK(none.changes.cols() == 0);
}
