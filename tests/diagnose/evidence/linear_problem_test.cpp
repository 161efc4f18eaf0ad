#include "diagnose/evidence/linear_problem.hpp"

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include "machine/machines.hpp"

namespace plumbline::diagnose {
namespace {

// The least of |r - J_T x|^2 + (x + d)^T D (x + d) over x, worked out with all rows at hand.
double least_misfit(const Eigen::MatrixXd& J, const Eigen::VectorXd& r, const Marginalised& taken) {
  const Eigen::MatrixXd own = J(Eigen::all, taken.columns);
  const Eigen::MatrixXd D = taken.precision.asDiagonal();
  const Eigen::MatrixXd A = own.transpose() * own + D;
  const Eigen::VectorXd x = A.ldlt().solve(own.transpose() * r - D * taken.departure);
  const Eigen::VectorXd off = x + taken.departure;
  return (r - own * x).squaredNorm() + off.dot(D * off);
}

}  // namespace

TEST_CASE("what is left of the residual is the least misfit of data and priors") {
  testing::Random random(7);
  Eigen::MatrixXd rows(30, 6);
  for (double& x : rows.reshaped()) x = testing::uniform(random, -1, 1);
  LinearProblem problem;
  problem.gram = rows.transpose() * rows;
  Marginalised taken;
  taken.columns = {0, 3};
  taken.precision = Eigen::Vector2d(1, 4);
  taken.departure = Eigen::Vector2d(0.5, -2);
  const Eigen::MatrixXd left = left_of(problem, taken);
  CHECK(left(5, 5) == Approx(least_misfit(rows.leftCols(5), rows.col(5), taken)));
  CHECK((left - left.transpose()).norm() < 1e-9);
  // what else is fitted takes from what is left: G - G_T (G_TT + D)^-1 G_T^T
  Marginalised more = taken;
  more.columns.push_back(1);
  more.precision = Eigen::Vector3d(1, 4, 1e-9);
  more.departure = Eigen::Vector3d(0.5, -2, 0);
  const double gain = left(1, 5) * left(1, 5) / left(1, 1);
  CHECK(left_of(problem, more)(5, 5) == Approx(left(5, 5) - gain));
}

}  // namespace plumbline::diagnose
