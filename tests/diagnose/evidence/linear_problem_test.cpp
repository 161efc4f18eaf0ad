#include "diagnose/evidence/linear_problem.hpp"

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include "machine/machines.hpp"

namespace plumbline::diagnose {
namespace {

// The least of |r - J_T x|^2 + (x + d)^T D (x + d) over x, worked out with all rows at hand.
double least_misfit(const Eigen::MatrixXd& J, const Eigen::VectorXd& r, const Marginalised& marginalised) {
  const Eigen::MatrixXd own = J(Eigen::all, marginalised.columns);
  const Eigen::MatrixXd D = marginalised.precision.asDiagonal();
  const Eigen::MatrixXd A = own.transpose() * own + D;
  const Eigen::VectorXd x = A.ldlt().solve(own.transpose() * r - D * marginalised.departure);
  const Eigen::VectorXd off = x + marginalised.departure;
  return (r - own * x).squaredNorm() + off.dot(D * off);
}

}  // namespace

TEST_CASE("what is left of the residual is the least misfit of data and priors") {
  testing::Random random(7);
  Eigen::MatrixXd rows(30, 6);
  for (double& x : rows.reshaped()) x = testing::uniform(random, -1, 1);
  LinearProblem problem;
  problem.gram = rows.transpose() * rows;
  Marginalised marginalised;
  marginalised.columns = {0, 3};
  marginalised.precision = Eigen::Vector2d(1, 4);
  marginalised.departure = Eigen::Vector2d(0.5, -2);
  const Eigen::MatrixXd reduced = reduced_gram(problem, marginalised);
  CHECK(reduced(5, 5) == Approx(least_misfit(rows.leftCols(5), rows.col(5), marginalised)));
  CHECK((reduced - reduced.transpose()).norm() < 1e-9);
  // what else is fitted takes from what is left: G - G_T (G_TT + D)^-1 G_T^T
  Marginalised more = marginalised;
  more.columns.push_back(1);
  more.precision = Eigen::Vector3d(1, 4, 1e-9);
  more.departure = Eigen::Vector3d(0.5, -2, 0);
  const double gain = reduced(1, 5) * reduced(1, 5) / reduced(1, 1);
  CHECK(reduced_gram(problem, more)(5, 5) == Approx(reduced(5, 5) - gain));
}

}  // namespace plumbline::diagnose
