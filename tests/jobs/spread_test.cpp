#include "jobs/spread.hpp"

#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("shares of many numbers are known to half a percent, from above") {
  std::mt19937_64 random(5);
  std::lognormal_distribution<double> drawn(-12, 2);
  jobs::Spread spread;
  std::vector<double> values;
  for (int i = 0; i < 5000; ++i) {
    values.push_back(drawn(random));
    spread.add(values.back());
  }
  std::sort(values.begin(), values.end());
  CHECK(spread.count() == 5000);
  CHECK(spread.least() == values.front());
  CHECK(spread.largest() == values.back());
  for (const double share : {0.01, 0.05, 0.5, 0.95, 0.999}) {
    INFO(share);
    const double exact = values[static_cast<std::size_t>(share * 5000) - 1];
    CHECK(spread.bound_of(share) >= exact);
    CHECK(spread.bound_of(share) <= exact * 1.0051);
  }
  CHECK(spread.bound_of(1) == values.back());
}

TEST_CASE("one number, none, and nothing but zeros") {
  jobs::Spread spread;
  CHECK(spread.bound_of(0.5) == 0);
  spread.add(3e-6);
  CHECK(spread.bound_of(0.05) == 3e-6);
  CHECK(spread.bound_of(0.95) == 3e-6);
  jobs::Spread zeros;
  zeros.add(0);
  zeros.add(0);
  CHECK(zeros.bound_of(0.95) == 0);
}
