#include "diagnose/evidence/score.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace plumbline::diagnose {
namespace {

TEST_CASE("the evidence of one number grows with half its gain and falls with its logarithm") {
  // tau^2 at its best: log BF = (g - 1 - log g) / 2
  const Eigen::MatrixXd A = Eigen::MatrixXd::Constant(1, 1, 4.0);
  for (const double gain : {9.0, 40.0, 400.0}) {
    const Eigen::VectorXd size = Eigen::VectorXd::Constant(1, std::sqrt(gain / 4));
    CHECK(log_bayes_factor(A, gain, size, 0) == Approx(0.5 * (gain - 1 - std::log(gain))).margin(0.15));
    CHECK(log_bayes_factor(A, gain, size, 1) == Approx(log_bayes_factor(A, gain, size, 0) + std::log(2)));
  }
}

}  // namespace
}  // namespace plumbline::diagnose
