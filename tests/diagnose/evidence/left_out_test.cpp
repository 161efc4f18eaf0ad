#include "diagnose/evidence/left_out.hpp"

#include <cmath>
#include <random>

#include <Eigen/LU>
#include <catch2/catch.hpp>

namespace plumbline::diagnose {
namespace {

constexpr int kRows = 12;

// Six runs; column 0 a nuisance, column 1 an effect, the residual last. `own` of the residual is the effect's column
// times a size that each pair of runs (a pose) has for itself.
LinearProblem problem_of(const std::vector<double>& own) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  LinearProblem problem;
  problem.gram.setZero(3, 3);
  for (int run = 0; run < 6; ++run) {
    Block block;
    block.rows = Eigen::MatrixXd::NullaryExpr(kRows, 3, [&] { return normal(random); });
    block.rows.col(2) += own[static_cast<std::size_t>(run / 2)] * block.rows.col(1);
    block.gram = block.rows.transpose() * block.rows;
    problem.gram += block.gram;
    problem.blocks.push_back(block);
  }
  return problem;
}

const Marginalised kTaken{{0}, Eigen::VectorXd::Ones(1), Eigen::VectorXd::Zero(1)};
const std::vector<int> kPoses{0, 0, 1, 1, 2, 2};

// log of the normal density of y with that covariance, without the constant.
double log_density(const Eigen::VectorXd& y, const Eigen::MatrixXd& covariance) {
  return -0.5 * (y.dot(covariance.inverse() * y) + std::log(covariance.determinant()));
}

// log p(y of these runs) with unknowns normal of these variances.
double by_covariance(const LinearProblem& problem, const std::vector<int>& runs, const Eigen::VectorXd& variances) {
  const auto count = static_cast<Eigen::Index>(runs.size());
  Eigen::MatrixXd J(kRows * count, variances.size());
  Eigen::VectorXd y(kRows * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const identify::SlopeRows& rows = problem.blocks[static_cast<std::size_t>(runs[static_cast<std::size_t>(i)])].rows;
    J.middleRows(kRows * i, kRows) = rows.leftCols(variances.size());
    y.segment(kRows * i, kRows) = rows.col(2);
  }
  const Eigen::MatrixXd covariance =
      Eigen::MatrixXd::Identity(y.size(), y.size()) + J * variances.asDiagonal() * J.transpose();
  return log_density(y, covariance);
}

TEST_CASE("nats of poses left out are those of the normal densities of all readings") {
  const LinearProblem problem = problem_of({2, 2, 2});
  const Eigen::VectorXd size = Eigen::VectorXd::Constant(1, 1.9);
  const Eigen::Vector2d with(1, 1.9 * 1.9);
  const Eigen::VectorXd without = Eigen::VectorXd::Ones(1);
  double expected = 0;
  for (const std::vector<int>& others : {std::vector<int>{2, 3, 4, 5}, {0, 1, 4, 5}, {0, 1, 2, 3}}) {
    const std::vector<int> all{0, 1, 2, 3, 4, 5};
    expected += by_covariance(problem, all, with) - by_covariance(problem, others, with);
    expected -= by_covariance(problem, all, without) - by_covariance(problem, others, without);
  }
  CHECK(left_out_nats(problem, kTaken, {1}, size, kPoses) == Approx(expected).epsilon(1e-8));
  CHECK(expected > 20);
}

TEST_CASE("what helps only where it was fitted predicts nothing") {
  // each pose has another size, and the mean is nil: poses do not predict each other, runs of a pose do
  const LinearProblem problem = problem_of({3, -3, 0});
  const Eigen::VectorXd size = Eigen::VectorXd::Constant(1, 2);
  CHECK(left_out_nats(problem, kTaken, {1}, size, kPoses) < -20);
  CHECK(left_out_nats(problem, kTaken, {1}, size, {0, 1, 2, 3, 4, 5}) >
        left_out_nats(problem, kTaken, {1}, size, kPoses) + 5);
}

TEST_CASE("an effect that is a nuisance, too, has its own prior in place of the nuisance's") {
  const LinearProblem problem = problem_of({2, 2, 2});
  const Marginalised both{{0, 1}, Eigen::Vector2d(1, 1e4), Eigen::Vector2d::Zero()};
  const Eigen::VectorXd size = Eigen::VectorXd::Constant(1, 2);
  CHECK(left_out_nats(problem, both, {1}, size, kPoses) > 20);
}

}  // namespace
}  // namespace plumbline::diagnose
