#include "diagnose/evidence/bounded.hpp"

#include <random>

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

namespace plumbline::diagnose {
namespace {

struct Problem {
  Eigen::MatrixXd A;
  Eigen::VectorXd b, lower, upper;
  double value(const Eigen::VectorXd& x) const { return 0.5 * x.dot(A * x) - b.dot(x); }
};

Problem drawn(Eigen::Index n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  const Eigen::MatrixXd J = Eigen::MatrixXd::NullaryExpr(n + 2, n, draw);
  return {J.transpose() * J, Eigen::VectorXd::NullaryExpr(n, draw) * 3, Eigen::VectorXd::Zero(n),
          Eigen::VectorXd::Constant(n, 0.8)};
}

// The best of all ways in which each number is at its lower bound, at its upper one, or free.
double best_by_trying_all(const Problem& p) {
  const Eigen::Index n = p.b.size();
  double best = 1e300;
  int ways = 1;
  for (Eigen::Index i = 0; i < n; ++i) ways *= 3;
  for (int way = 0; way < ways; ++way) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    std::vector<Eigen::Index> free;
    int code = way;
    for (Eigen::Index i = 0; i < n; ++i, code /= 3) {
      if (code % 3 == 0) x[i] = p.lower[i];
      if (code % 3 == 1) x[i] = p.upper[i];
      if (code % 3 == 2) free.push_back(i);
    }
    if (!free.empty()) {
      const Eigen::VectorXd step =
          Eigen::MatrixXd(p.A(free, free)).ldlt().solve(Eigen::VectorXd((p.b - p.A * x)(free)));
      for (std::size_t k = 0; k < free.size(); ++k) x[free[k]] += step[static_cast<Eigen::Index>(k)];
    }
    const bool within = ((x - p.lower).array() > -1e-12).all() && ((p.upper - x).array() > -1e-12).all();
    if (within) best = std::min(best, p.value(x));
  }
  return best;
}

TEST_CASE("bounded least squares finds what trying all active sets finds") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 60; ++trial) {
    const Problem p = drawn(1 + trial % 6, random);
    const Eigen::VectorXd x = solve_bounded(p.A, p.b, p.lower, p.upper);
    CAPTURE(trial, x.transpose());
    CHECK((x.array() >= p.lower.array()).all());
    CHECK((x.array() <= p.upper.array()).all());
    CHECK(p.value(x) == Approx(best_by_trying_all(p)).margin(1e-10));
  }
}

TEST_CASE("bounds that do not matter leave the unbounded solution") {
  std::mt19937 random(3);
  Problem p = drawn(5, random);
  p.lower.setConstant(-1e3);
  p.upper.setConstant(1e3);
  const Eigen::VectorXd x = solve_bounded(p.A, p.b, p.lower, p.upper);
  CHECK((x - p.A.ldlt().solve(p.b)).norm() < 1e-10);
}

}  // namespace
}  // namespace plumbline::diagnose
