#include "inspect/prediction.hpp"

#include <catch2/catch.hpp>

#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

// A prior of as many independent columns, each of spread one, that belong to effects.
inspect::Prior prior_of(std::vector<int> effects) {
  inspect::Prior prior;
  const auto count = static_cast<Eigen::Index>(effects.size());
  prior.precision = Eigen::VectorXd::Ones(count);
  prior.least = 1e-3 * Eigen::VectorXd::Ones(count);
  prior.most = Eigen::VectorXd::Ones(count);
  for (std::size_t i = 0; i < effects.size(); ++i) prior.columns.push_back(static_cast<int>(i));
  prior.effect = std::move(effects);
  return prior;
}

inspect::RunRows rows_of(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& left) {
  inspect::RunRows rows;
  rows.slopes = slopes;
  rows.left = left;
  rows.gram = slopes.transpose() * slopes;
  rows.pull = slopes.transpose() * left;
  return rows;
}

}  // namespace

TEST_CASE("a prediction weighs what is off by noise and by what is not known of the machine") {
  Random random(4);
  std::normal_distribution<double> normal;
  const auto drawn = [&](Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); }));
  };
  const inspect::Prior prior = prior_of({0, 0, 1});
  inspect::Knowledge known(prior);
  const inspect::RunRows other = rows_of(drawn(20, 3), drawn(20, 1));
  known.add(other);
  const inspect::RunRows run = rows_of(drawn(12, 3), drawn(12, 1));
  // by the full covariance, 1 + N C N^T
  const Eigen::MatrixXd C = known.information.inverse();
  const Eigen::MatrixXd full = Eigen::MatrixXd::Identity(12, 12) + run.slopes * C * run.slopes.transpose();
  const Eigen::VectorXd off = run.left - run.slopes * (C * known.pull);
  const inspect::Prediction prediction(known, run.slopes);
  CHECK(prediction.chi2(run.left) == Approx(off.dot(full.inverse() * off)));
  CHECK((prediction.off(run.left) - off).norm() < 1e-10);
  const Eigen::MatrixXd A = drawn(12, 2);
  const Eigen::MatrixXd of_A = A.transpose() * full.inverse() * A;
  CHECK((prediction.products(A, A) - of_A).norm() < 1e-9);
  CHECK((prediction.squares(A) - of_A.diagonal()).norm() < 1e-9);
  CHECK(prediction.square(A.col(0)) == Approx(of_A(0, 0)));
  CHECK(prediction.product(A.col(0), A.col(1)) == Approx(of_A(0, 1)));
  const Eigen::MatrixXd B = drawn(12, 3);
  CHECK((prediction.products(A, B) - A.transpose() * full.inverse() * B).norm() < 1e-9);
}

TEST_CASE("effects that runs do not need shrink to nothing, and those that they need do not") {
  Random random(5);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd slopes = Eigen::MatrixXd::NullaryExpr(200, 4, [&] { return normal(random); });
  const Eigen::VectorXd truth = (Eigen::VectorXd(4) << 0.5, -0.4, 0, 0).finished();
  const Eigen::VectorXd left =
      slopes * truth + 0.01 * Eigen::VectorXd::NullaryExpr(200, [&] { return normal(random); });
  slopes *= 100;  // noise of one
  const inspect::RunRows run = rows_of(slopes, 100 * left);
  inspect::Prior prior = prior_of({0, 0, 1, 1});
  inspect::fit_spreads(prior, {&run}, 20);
  CHECK(1 / std::sqrt(prior.precision[0]) == Approx(0.45).margin(0.1));
  CHECK(prior.precision[0] == prior.precision[1]);
  CHECK(1 / std::sqrt(prior.precision[2]) < 0.01);
}
