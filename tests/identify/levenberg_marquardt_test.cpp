#include "identify/levenberg_marquardt.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace plumbline::identify;

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// The sum of squares of residuals r, whose slopes are J.
SumOfSquares sum_of(const Eigen::VectorXd& r, const Eigen::MatrixXd& J) {
  return {r.squaredNorm(), J.transpose() * r, J.transpose() * J};
}

SumAt linear(const Eigen::MatrixXd& J, const Eigen::VectorXd& right) {
  return [=](const Eigen::VectorXd& z, bool) { return sum_of(J * z - right, J); };
}

Bounds no_bounds(Eigen::Index size) {
  return {Eigen::VectorXd::Constant(size, -kNone), Eigen::VectorXd::Constant(size, kNone)};
}

// [Rosenbrock 1960]
std::optional<SumOfSquares> valley(const Eigen::VectorXd& z, bool) {
  Eigen::Vector2d r(1 - z[0], 10 * (z[1] - z[0] * z[0]));
  Eigen::Matrix2d J;
  J << -1, 0, -20 * z[0], 10;
  return sum_of(r, J);
}

}  // namespace

TEST_CASE("equations that are linear are solved by the first step") {
  Eigen::Matrix<double, 4, 3> J;
  J << 1, 2, 0, 0, 1e3, 1, 2, 0, 1e-3, 1, 1, 1;
  const Eigen::Vector4d right(1, -2, 3, 0.5);
  const Eigen::Vector3d start(5, -5, 5);
  const Least found = least_squares(linear(J, right), start, no_bounds(3));
  const Eigen::Vector3d expected = J.colPivHouseholderQr().solve(right);
  CHECK(found.converged);
  CHECK(found.iterations == 2);
  // the first step's damping, 1e-10 of the diagonal, leaves about as much of the way
  CHECK((found.z - expected).norm() < 1e-9 * (J * (start - expected)).norm());
}

TEST_CASE("a valley that bends is followed to its lowest point") {
  const Least found = least_squares(valley, Eigen::Vector2d(-1.2, 1), no_bounds(2), {.most_iterations = 100});
  CHECK(found.converged);
  CHECK((found.z - Eigen::Vector2d(1, 1)).norm() < 1e-6);
  CHECK_FALSE(found.stopped_because.empty());
}

TEST_CASE("the least within bounds is where a search over all of them finds it") {
  Eigen::Matrix2d J;
  J << 1, 0.9, 0.9, 1;
  const Eigen::Vector2d right(2, -1);
  const Bounds bounds{Eigen::Vector2d(-0.5, -0.75), Eigen::Vector2d(1, 2)};
  const Least found = least_squares(linear(J, right), Eigen::Vector2d(0.3, 0.3), bounds);
  Eigen::Vector2d best = bounds.lower;
  for (double x = bounds.lower[0]; x <= bounds.upper[0]; x += 1.0 / 1024) {
    for (double y = bounds.lower[1]; y <= bounds.upper[1]; y += 1.0 / 1024) {
      if ((J * Eigen::Vector2d(x, y) - right).norm() < (J * best - right).norm()) best = {x, y};
    }
  }
  CHECK(found.converged);
  CHECK((found.z - best).norm() < 2e-3);
  CHECK((J * found.z - right).norm() <= (J * best - right).norm() + 1e-9);
  CHECK((found.z.array() >= bounds.lower.array()).all());
  CHECK((found.z.array() <= bounds.upper.array()).all());
}

TEST_CASE("a bent valley within bounds ends at the bound") {
  const Bounds bounds{Eigen::Vector2d(-2, -2), Eigen::Vector2d(0.5, 2)};
  const Least found = least_squares(valley, Eigen::Vector2d(-1.2, 1), bounds, {.most_iterations = 100});
  CHECK(found.converged);
  CHECK(found.z[0] == 0.5);
  CHECK(std::abs(found.z[1] - 0.25) < 1e-6);
}

TEST_CASE("a start beyond the bounds is moved into them") {
  const Bounds bounds{Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)};
  const Least found =
      least_squares(linear(Eigen::Matrix2d::Identity(), Eigen::Vector2d(0.5, 3)), Eigen::Vector2d(-7, 9), bounds);
  CHECK((found.z - Eigen::Vector2d(0.5, 1)).norm() < 1e-8);
}

TEST_CASE("a step to where there is no sum is made shorter") {
  int refused = 0;
  const SumAt to_two = [&](const Eigen::VectorXd& z, bool derivatives) -> std::optional<SumOfSquares> {
    if (std::abs(z[0]) > 2) {
      ++refused;
      return std::nullopt;
    }
    return valley(z, derivatives);
  };
  const Least found = least_squares(to_two, Eigen::Vector2d(0.01, -2), no_bounds(2), {.most_iterations = 200});
  CHECK(found.converged);
  CHECK((found.z - Eigen::Vector2d(1, 1)).norm() < 1e-6);
  const Least none = least_squares(to_two, Eigen::Vector2d(3, 0), no_bounds(2));
  CHECK_FALSE(none.converged);
  CHECK(none.z == Eigen::Vector2d(3, 0));
  CHECK(refused > 0);
}

TEST_CASE("what was not reached in the steps allowed has not converged") {
  const Least found = least_squares(valley, Eigen::Vector2d(-1.2, 1), no_bounds(2), {.most_iterations = 2});
  CHECK_FALSE(found.converged);
  CHECK_FALSE(found.stopped_because.empty());
}

TEST_CASE("a direction that nothing tells is left where it was") {
  Eigen::Matrix2d J;
  J << 1, 1, 2, 2;
  const Least found = least_squares(linear(J, Eigen::Vector2d(2, 4)), Eigen::Vector2d(3, -3), no_bounds(2));
  CHECK(found.converged);
  CHECK((found.z - Eigen::Vector2d(4, -2)).norm() < 1e-6);
}
