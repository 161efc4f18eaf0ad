#include "diagnose/residual_model/law.hpp"

#include <cmath>
#include <functional>
#include <random>

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

struct Learnt {
  Component component;
  Eigen::MatrixXd covariance;
};

// A function of all struts' tension or length as readings of a micrometre's noise leave it. The unit of readings is um.
Learnt learnt(int coordinate, double middle, double half_width, const std::function<double(double)>& function_um,
              double noise_um = 0.5) {
  constexpr int kReadings = 400;
  testing::Random random(7);
  std::normal_distribution<double> normal;
  Learnt of;
  Component& component = of.component;
  component.shape.coordinates = {coordinate};
  component.region.middle = {middle};
  component.region.half_width = {half_width};
  component.parts = {-1};
  component.spread = 20e-6;
  component.sigmas = component.spread * prior_widths(component.shape, 0.3);
  Eigen::MatrixXd functions(kReadings, component.shape.functions());
  Eigen::VectorXd readings(kReadings);
  for (int i = 0; i < kReadings; ++i) {
    const double at = middle + half_width * (2.0 * i / (kReadings - 1) - 1);
    functions.row(i) = functions_at(component.shape, component.region, {at});
    readings[i] = 1e-6 * (function_um(at) + noise_um * normal(random));
  }
  const double precision = 1e12 / (noise_um * noise_um);
  Eigen::MatrixXd information = precision * functions.transpose() * functions;
  information.diagonal() += component.sigmas.cwiseAbs2().cwiseInverse();
  of.covariance = information.ldlt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  component.weights = of.covariance * (precision * functions.transpose() * readings);
  return of;
}

std::optional<PowerLaw> law_of(const Learnt& of) {
  return power_law_of(of.component, of.covariance, physics::ForceModel(testing::pm600_like()).machine);
}

double power(double x, double exponent) { return std::copysign(std::pow(std::abs(x), exponent), x); }

TEST_CASE("the power of a function is found, with its sign and size") {
  struct Drawn {
    double size, exponent, middle, half_width;
  };
  for (const Drawn& drawn : {Drawn{8, 2.0 / 3, 0.7, 1.6}, Drawn{-8, 2.0 / 3, 1.0, 1.1}, Drawn{5, 2, 0.5, 2},
                             Drawn{-20, 1.5, 0, 1}, Drawn{12, 0.5, 0.9, 1.2}}) {
    CAPTURE(drawn.size, drawn.exponent);
    const auto law = law_of(learnt(coordinates::kTension, drawn.middle, drawn.half_width,
                                   [&](double t) { return drawn.size * power(t, drawn.exponent); }));
    REQUIRE(law);
    CHECK(law->least <= law->exponent);
    CHECK(law->exponent <= law->most);
    CHECK(std::abs(law->exponent - drawn.exponent) < 0.05);
    CHECK(law->size == Approx(drawn.size * 1e-6).epsilon(0.05));
    CHECK(law->size_sigma < 0.05 * std::abs(law->size));
  }
}

TEST_CASE("a power of a strut's length is one of its share of the middle one") {
  const double middle_m = physics::ForceModel(testing::pm600_like()).machine.middle_length.mean();
  const auto law = law_of(learnt(coordinates::kLength, 0, 3, [&](double at) {
    return 300 * std::pow((middle_m + kCoordinateLength * at) / middle_m, 2);
  }));
  REQUIRE(law);
  CHECK(std::abs(law->exponent - 2) < 0.05);
  CHECK(law->size == Approx(300e-6).epsilon(0.01));
}

TEST_CASE("what is no power, or not known well enough, is none") {
  const auto bump = [](double t) { return 10 * std::exp(-8 * (t - 1) * (t - 1)); };
  CHECK_FALSE(law_of(learnt(coordinates::kTension, 0.7, 1.6, bump)));
  const auto steps = [](double t) { return 5 * std::sin(6 * t); };
  CHECK_FALSE(law_of(learnt(coordinates::kTension, 0.7, 1.6, steps)));
  const auto weak = [](double t) { return 0.2 * power(t, 2.0 / 3); };
  CHECK_FALSE(law_of(learnt(coordinates::kTension, 0.7, 1.6, weak, 2)));
  // tensions between 1.0 and 1.2 kN leave all exponents
  const auto narrow = [](double t) { return 8 * power(t, 2.0 / 3); };
  CHECK_FALSE(law_of(learnt(coordinates::kTension, 1.1, 0.1, narrow, 10)));
}

TEST_CASE("one strut's function and one of another coordinate are left as they are") {
  const auto hertz = [](double t) { return 8 * power(t, 2.0 / 3); };
  Learnt of = learnt(coordinates::kTension, 0.7, 1.6, hertz);
  of.component.parts = {2};
  CHECK_FALSE(law_of(of));
  CHECK_FALSE(law_of(learnt(coordinates::kUz, 0.7, 1.6, hertz)));
}

}  // namespace
}  // namespace plumbline::diagnose
