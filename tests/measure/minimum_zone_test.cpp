#include "measure/minimum_zone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

double width_at(const Eigen::VectorXd& angle, const Eigen::VectorXd& reading, double x, double y) {
  const Eigen::ArrayXd left = reading.array() - x * angle.array().cos() - y * angle.array().sin();
  return left.maxCoeff() - left.minCoeff();
}

// The least value of a convex function, by thirds.
template <class Function>
double least(Function f, double low, double high) {
  for (int i = 0; i < 90; ++i) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return f((low + high) / 2);
}

double brute_force(const Eigen::VectorXd& angle, const Eigen::VectorXd& reading) {
  const double far = 10 * reading.cwiseAbs().maxCoeff() + 1;
  return least([&](double x) { return least([&](double y) { return width_at(angle, reading, x, y); }, -far, far); },
               -far, far);
}

}  // namespace

TEST_CASE("the minimum zone is the least width of all centres") {
  Random random(31);
  for (int n = 0; n < 60; ++n) {
    INFO("profile " << n);
    const int samples = 3 + static_cast<int>(uniform(random, 0, 60));
    const bool even = n % 2 == 0;
    Eigen::VectorXd angle(samples);
    Eigen::VectorXd reading(samples);
    for (int i = 0; i < samples; ++i) {
      angle[i] = even ? 2 * std::numbers::pi * i / samples : uniform(random, 0, 7);
      reading[i] = uniform(random, -1, 1) + 20 * std::cos(angle[i] - 1);
    }
    if (n % 3 == 0) reading = (reading * 4).array().round() / 4;  // as a coarse display shows them
    const Zone zone = minimum_zone(angle, reading);
    CHECK(zone.width() == Approx(width_at(angle, reading, zone.x, zone.y)).margin(1e-9));
    const Eigen::ArrayXd left = reading.array() - zone.x * angle.array().cos() - zone.y * angle.array().sin();
    CHECK(left.maxCoeff() <= zone.outer + 1e-12);
    CHECK(left.minCoeff() >= zone.inner - 1e-12);
    const double brute = brute_force(angle, reading);
    CHECK(zone.width() <= brute + 1e-9);
    CHECK(zone.width() >= brute - 1e-6);
  }
}

TEST_CASE("a profile without deviations, in metres") {
  const Eigen::VectorXd angle = Eigen::VectorXd::LinSpaced(3600, 0, 2 * std::numbers::pi);
  const Eigen::VectorXd reading = 1e-6 * (2 + angle.array().cos() - 3 * angle.array().sin());
  const Zone zone = minimum_zone(angle, reading);
  CHECK(zone.width() == Approx(0).margin(1e-15));
  CHECK(zone.x == Approx(1e-6).margin(1e-13));
  CHECK(zone.y == Approx(-3e-6).margin(1e-13));
  CHECK(minimum_zone(angle, 0 * reading).width() == 0);
}
