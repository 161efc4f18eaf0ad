#include "base/same_value.hpp"

#include <limits>

#include <catch2/catch.hpp>

using namespace plumbline;

namespace {

struct Padded {
  char letter = 0;
  double value = 0;
  bool operator==(const Padded&) const = default;
};

}  // namespace

TEST_CASE("bytes without a meaning make no difference between values") {
  Padded a;
  Padded b;
  std::memset(static_cast<void*>(&a), 0x00, sizeof a);
  std::memset(static_cast<void*>(&b), 0xFF, sizeof b);
  a.letter = b.letter = 'X';
  a.value = 0.0;
  b.value = -0.0;
  CHECK(same_value(a, b));
  b.value = std::numeric_limits<double>::min();
  CHECK_FALSE(same_value(a, b));
  b.value = 0;
  b.letter = 'Y';
  CHECK_FALSE(same_value(a, b));
}
