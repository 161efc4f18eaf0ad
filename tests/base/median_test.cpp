#include "base/median.hpp"

#include <catch2/catch.hpp>

using plumbline::median;

TEST_CASE("the median is the middle one, of an even number the greater of the two") {
  CHECK(median({3}) == 3);
  CHECK(median({5, 1, 3}) == 3);
  CHECK(median({4, 1, 3, 2}) == 3);
}
