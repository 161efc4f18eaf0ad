#include "identify/posterior/normal_length.hpp"

#include <cmath>
#include <random>

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::identify;

namespace {

NormalLength along(double x, double y, double z, const Vector3<double>& mean = Vector3<double>::Zero()) {
  return {mean, Vector3<double>(x * x, y * y, z * z).asDiagonal()};
}

double within(const NormalLength& length) {
  const WeighedLength part{1, length};
  return length_within({&part, 1}, 0.95);
}

}  // namespace

TEST_CASE("a length of a normal vector is chi-square where that is known") {
  // 95 % points of chi-square with 1, 2, 3 degrees [tables]
  CHECK(within(along(1, 0, 0)) == Approx(std::sqrt(3.8415)).epsilon(0.01));
  CHECK(within(along(1, 1, 0)) == Approx(std::sqrt(5.9915)).epsilon(0.005));
  CHECK(within(along(1, 1, 1)) == Approx(std::sqrt(7.8147)).epsilon(0.005));
  CHECK(along(1, 1, 0).mean() == Approx(std::sqrt(M_PI / 2)).epsilon(1e-9));
  CHECK(along(2e-6, 2e-6, 2e-6).mean() == Approx(2e-6 * std::sqrt(8 / M_PI)).epsilon(1e-9));
  CHECK(along(1, 2, 3, {1, 0, 2}).rms() == Approx(std::sqrt(19.0)));
}

TEST_CASE("a vector that is known exactly is as long as it is") {
  CHECK(within(along(0, 0, 0, {3, 4, 0})) == Approx(5).epsilon(1e-5));
  CHECK(along(0, 0, 0, {3, 4, 0}).mean() == Approx(5));
}

TEST_CASE("one draw of twenty exceeds what 95 % do not") {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 12; ++n) {
    Eigen::Matrix3d root;
    for (double& x : root.reshaped()) x = normal(random);
    if (n % 3 == 0) root.col(2).setZero();
    const Vector3<double> mean = 1.5 * (n % 4) * Vector3<double>(normal(random), normal(random), normal(random));
    const NormalLength length(mean, root * root.transpose());
    const double bound = within(length);
    int beyond = 0;
    double sum = 0;
    constexpr int kDraws = 40000;
    for (int i = 0; i < kDraws; ++i) {
      const double drawn = (mean + root * Vector3<double>(normal(random), normal(random), normal(random))).norm();
      if (drawn > bound) ++beyond;
      sum += drawn;
    }
    INFO("case " << n);
    CHECK(beyond / double(kDraws) == Approx(0.05).margin(0.005));
    CHECK(sum / kDraws == Approx(length.mean()).epsilon(0.04));
  }
}

TEST_CASE("of several lengths the bound is that of the mixture") {
  const std::vector<WeighedLength> parts{{0.9, along(1, 1, 1)}, {0.1, along(1, 1, 1, {10, 0, 0})}};
  const double bound = length_within(parts, 0.95);
  CHECK(bound > 9);  // half of the tenth that lies there
  CHECK(bound < 11);
  const std::vector<WeighedNumber> numbers{{0.9, 0, 1}, {0.1, 10, 1}};
  CHECK(number_within(numbers, 0.95) == Approx(10).margin(0.3));
  const WeighedNumber one{1, 0, 2};
  CHECK(number_within({&one, 1}, 0.95) == Approx(2 * 1.95996).epsilon(1e-4));
}
