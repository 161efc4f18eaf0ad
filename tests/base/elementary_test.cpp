// Against the C library in long double, over the ranges that each function states.
#include "base/elementary.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

using namespace plumbline;

namespace {

using One = Lanes<AnyProcessor, 1>;
constexpr int kDraws = 200'000;

// Even in x and even in its logarithm, both signs.
std::vector<double> drawn(double most) {
  std::mt19937_64 random(29);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> drawn{0.0, -0.0, most, -most};
  for (int i = 0; i < kDraws; ++i) {
    drawn.push_back(most * unit(random));
    drawn.push_back(std::copysign(most * std::pow(10.0, -12 * std::abs(unit(random))), unit(random)));
  }
  return drawn;
}

long double off(double found, long double wanted) { return std::abs(static_cast<long double>(found) - wanted); }

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

template <int N, class Function>
void check_lanes(double most, Function&& function) {
  using T = Lanes<AnyProcessor, N>;
  const std::vector<double> xs = drawn(most);
  for (std::size_t first = 0; first + N <= xs.size() && first < 20'000; first += N) {
    const T many = function(T::load(&xs[first]));
    for (int lane = 0; lane < N; ++lane) {
      const double alone = function(One(xs[first + static_cast<std::size_t>(lane)]))[0];
      REQUIRE(same_bits(many[lane], alone));
    }
  }
}

}  // namespace

TEST_CASE("sine and cosine of lanes are right to the last places up to a million radians") {
  long double worst = 0;
  for (const double most : {0.8, 7.0, 1e3, 1e6}) {
    for (const double x : drawn(most)) {
      const auto found = sine_cosine(One(x));
      worst = std::max(worst, off(found.sine[0], std::sin(static_cast<long double>(x))));
      worst = std::max(worst, off(found.cosine[0], std::cos(static_cast<long double>(x))));
    }
  }
  CHECK(worst < 2.2e-16L);
  CHECK(std::isnan(sin(One(1.1e6))[0]));
  CHECK(std::isnan(cos(One(-1e300))[0]));
}

TEST_CASE("the exponential of lanes is right to the last places") {
  long double worst = 0;
  for (const double most : {1.0, 40.0, 699.0}) {
    for (const double x : drawn(most)) {
      const long double wanted = std::exp(static_cast<long double>(x));
      worst = std::max(worst, off(exp(One(x))[0], wanted) / wanted);
    }
  }
  CHECK(worst < 2.5e-16L);
  CHECK(exp(One(-701))[0] == 0);
  CHECK(exp(One(-1e300))[0] == 0);
  CHECK(std::isinf(exp(One(710))[0]));
  CHECK(std::isnan(exp(One(std::nan("")))[0]));
}

TEST_CASE("the hyperbolic tangent of lanes is right to 3e-16, and one from 20 on") {
  long double worst = 0;
  for (const double most : {0.1, 1.0, 25.0}) {
    for (const double x : drawn(most))
      worst = std::max(worst, off(tanh(One(x))[0], std::tanh(static_cast<long double>(x))));
  }
  CHECK(worst < 3e-16L);
  CHECK(tanh(One(20))[0] == 1);
  CHECK(tanh(One(-1e300))[0] == -1);
}

TEST_CASE("the arc tangents of lanes are right in all quadrants") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  long double worst = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double y = unit(random) * std::pow(10.0, 8 * unit(random));
    const double x = unit(random);
    const long double wanted = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    worst = std::max(worst, off(atan2(One(y), One(x))[0], wanted));
    const double t = 0.05 * unit(random);
    const long double small = std::atan(static_cast<long double>(t));
    CHECK(off(small_arc_tangent(One(t))[0], small) <= 2e-16L * std::abs(small));
  }
  CHECK(worst < 5e-16L);
  for (const auto& [y, x] : {std::pair(0.0, 1.0), {0.0, -1.0}, {1.0, 0.0}, {-1.0, 0.0}, {1.0, 1.0}, {-1.0, -1.0}}) {
    CHECK(atan2(One(y), One(x))[0] == Approx(std::atan2(y, x)).margin(1e-300));
  }
  CHECK(atan2(One(0), One(0))[0] == 0);
}

TEST_CASE("any number of lanes gives the bits of one") {
  const auto all = [](const auto& x) { return sin(x) + cos(x) * exp(x) + tanh(x) / (sqrt(abs(x)) + 1.0); };
  const auto turned = [](const auto& x) { return atan2(x, 2.0 - abs(x)) + small_arc_tangent(x * 1e-3); };
  check_lanes<2>(100, all);
  check_lanes<4>(100, all);
  check_lanes<8>(100, all);
  check_lanes<2>(100, turned);
  check_lanes<4>(100, turned);
  check_lanes<8>(100, turned);
}
