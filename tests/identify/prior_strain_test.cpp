#include "identify/prior_strain.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace plumbline::identify {

TEST_CASE("chi-square of the priors counts what the data tell alone") {
  const Eigen::Vector3d off(2, 0, -1);
  CHECK(prior_strain(off).chi2 == Approx(5));
  CHECK(prior_strain(off).degrees == 3);
  // told: the first in full, the second by half, the third not at all
  Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
  left.diagonal() << 0, 0.5, 1;
  CHECK(prior_strain(off, left, 0.03).chi2 == Approx(4));
  CHECK(prior_strain(off, left, 0.03).degrees == 2);
  CHECK(prior_strain(Eigen::Vector3d(0, 1, 0), left, 0.03).chi2 == Approx(2));
  CHECK(prior_strain(Eigen::VectorXd(0)).excess() == 0);
  CHECK(PriorStrain{}.deviate() == 0);
}

TEST_CASE("the strain of unknowns in their own units is that in sigmas") {
  const Eigen::Vector2d sigmas(1e-5, 0.05);
  const Eigen::Vector2d off(1.5, -2);
  Unknown length;
  length.sigma = sigmas[0];
  Unknown tilt;
  tilt.sigma = sigmas[1];
  tilt.start = 0.2;
  const Eigen::Vector2d values(off[0] * sigmas[0], tilt.start + off[1] * sigmas[1]);
  const Eigen::Matrix2d posterior = (Eigen::Matrix2d() << 0.3, 0.1, 0.1, 0.6).finished();
  const Eigen::MatrixXd covariance = sigmas.asDiagonal() * posterior * sigmas.asDiagonal();
  const PriorStrain in_sigmas = prior_strain(off, posterior, 0.03);
  const PriorStrain in_units = prior_strain({&length, &tilt}, values, covariance, 0.03);
  CHECK(in_units.chi2 == Approx(in_sigmas.chi2));
  CHECK(in_units.degrees == in_sigmas.degrees);
  CHECK(in_units.widening() == Approx(in_sigmas.chi2 / in_sigmas.degrees));
  CHECK(PriorStrain{0.5, 2}.widening() == 1);
  CHECK(prior_strain({}, {}, {}, 0.03).widening() == 1);
}

TEST_CASE("chi-square as a deviate and in its standard deviations agree where degrees are many") {
  // tables of chi-square: 99.9 % of 10 degrees lie below 29.59, of 100 below 149.45
  CHECK(PriorStrain{29.59, 10}.deviate() == Approx(3.09).margin(0.02));
  CHECK(PriorStrain{149.45, 100}.deviate() == Approx(3.09).margin(0.01));
  const PriorStrain many{1e4 + 3 * std::sqrt(2e4), 1e4};
  CHECK(many.excess() == Approx(3));
  CHECK(many.deviate() == Approx(3).margin(0.05));
}

}  // namespace plumbline::identify
