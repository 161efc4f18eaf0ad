#include "measure/circularity.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "measure/runs.hpp"

using namespace plumbline;
using namespace plumbline::measure;

namespace {

template <class Reading>
Profile profile(int samples, Reading reading) {
  Profile p{Eigen::VectorXd(samples), Eigen::VectorXd(samples)};
  for (int i = 0; i < samples; ++i) {
    p.angle[i] = 2 * std::numbers::pi * i / samples;
    p.reading[i] = reading(p.angle[i]);
  }
  return p;
}

Approx near(double value) { return Approx(value).margin(1e-9).epsilon(0); }

}  // namespace

TEST_CASE("an ellipse whose ball stands off the centre") {
  // mean 5, centre (3, 4), 2 cos 2 phi: both reference circles touch it at the ends of its axes
  const Profile p = profile(360, [](double a) { return 5 + 3 * std::cos(a) + 4 * std::sin(a) + 2 * std::cos(2 * a); });
  const CircularityFigures f = circularity_figures(p);
  CHECK(f.circle.mean == near(5));
  CHECK(f.circle.x == near(3));
  CHECK(f.circle.y == near(4));
  CHECK(f.least_squares == near(4));
  CHECK(f.minimum_zone == near(4));
  CHECK(f.radial_max == near(7));
  CHECK(f.radial_min == near(3));
  CHECK(without_setup(p, f.circle).maxCoeff() == near(2));
}

TEST_CASE("one of eight readings sticks out: the minimum zone is narrower than the least squares say") {
  // least squares: mean 1/8, x 1/4; 5/8 left at 0 deg, -1/8 - sqrt(1/2)/4 at 45 deg.
  // minimum zone: x = 1/2 evens out 0 and 180 deg at 1/2, 45 deg lies at -sqrt(1/2)/2.
  const Profile p = profile(8, [](double a) { return a == 0 ? 1.0 : 0.0; });
  const CircularityFigures f = circularity_figures(p);
  CHECK(f.least_squares == near(0.75 + std::sqrt(0.5) / 4));
  CHECK(f.minimum_zone == near((2 + std::sqrt(2.0)) / 4));
}

TEST_CASE("both directions: one ring for both, and their mean radius") {
  // ccw 1 + cos phi, cw 3 - cos phi: the common centre is 0, the ring spans from 0 (ccw at 180 deg) to 4
  const Profile ccw = profile(72, [](double a) { return 1 + std::cos(a); });
  const Profile cw = profile(72, [](double a) { return 3 - std::cos(a); });
  const BidirectionalFigures f = bidirectional_figures(ccw, cw);
  CHECK(f.minimum_zone == near(4));
  CHECK(f.least_squares == near(4));
  CHECK(f.mean_radial == near(2));
  CHECK(circularity_figures(ccw).minimum_zone == near(0));
}

TEST_CASE("harmonics have amplitude and phase, whatever the spacing of the samples") {
  Profile p = profile(90, [](double) { return 0; });
  for (int i = 0; i < 90; ++i) {
    const double a = p.angle[i] += 0.01 * std::sin(i * 1.7);
    p.reading[i] = 7 + 3 * std::cos(a - 0.5) + 1.5 * std::cos(3 * a + 2);
  }
  const std::vector<Harmonic> found = harmonics(p, 5);
  REQUIRE(found.size() == 5);
  CHECK(found[0].amplitude == near(3));
  CHECK(found[0].phase == near(0.5));
  CHECK(found[1].amplitude == near(0));
  CHECK(found[2].order == 3);
  CHECK(found[2].amplitude == near(1.5));
  CHECK(found[2].phase == near(-2));
  CHECK(harmonics(profile(8, [](double a) { return std::cos(a); }), 20).size() == 3);
}

TEST_CASE("a step at a reversal, on a bent profile, also across zero") {
  const auto stepped = [](double at) {
    return profile(360, [at](double a) {
      const double d = std::remainder(a - at, 2 * std::numbers::pi);
      return 2 + d - 3 * d * d + (d > 0 ? 4.0 : 0.0);
    });
  };
  for (const double at : {100.5 * kDeg, 0.25 * kDeg}) {
    const std::optional<double> step = reversal_step(stepped(at), at, 15 * kDeg);
    REQUIRE(step.has_value());
    CHECK(*step == near(4));
  }
  CHECK_FALSE(reversal_step(stepped(0), 0, 3 * kDeg).has_value());
}
