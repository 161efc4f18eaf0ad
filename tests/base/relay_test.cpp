#include "base/relay.hpp"

#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>

using plumbline::Relay;

TEST_CASE("batches are taken in the order in which they are handed over, all of them by the end") {
  std::vector<int> taken;
  Relay<std::vector<int>> relay([&](std::vector<int>& batch) {
    taken.insert(taken.end(), batch.begin(), batch.end());
    batch.clear();
  });
  std::vector<int> batch;
  for (int i = 0; i < 1000; ++i) {
    batch.push_back(i);
    if (i % 7 == 0) {
      relay.hand_over(batch);
      REQUIRE(batch.empty());
    }
  }
  relay.hand_over(batch);
  relay.finish();
  REQUIRE(taken.size() == 1000);
  for (int i = 0; i < 1000; ++i) CHECK(taken[static_cast<std::size_t>(i)] == i);
}

TEST_CASE("what taking a batch throws comes to who hands over, at the end at the latest") {
  Relay<int> relay([](int& batch) {
    if (batch == 3) throw std::runtime_error("three");
  });
  const auto hand_over_all = [&] {
    for (int i = 0; i < 100; ++i) {
      int batch = i;
      relay.hand_over(batch);
    }
    relay.finish();
  };
  CHECK_THROWS_WITH(hand_over_all(), "three");
}

TEST_CASE("a relay may be left with batches that wait") {
  int taken = 0;
  {
    Relay<int> relay([&](int&) { ++taken; });
    int batch = 0;
    for (int i = 0; i < 10; ++i) relay.hand_over(batch);
  }
  CHECK(taken <= 10);
}
