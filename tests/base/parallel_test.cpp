// The same work for many items on all processors.
#include "base/parallel.hpp"

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

#include <catch2/catch.hpp>
#ifdef __linux__
#include <sched.h>
#endif

using namespace plumbline;

namespace {

// What is thrown where every item from `first` on fails, the first of them last of all.
std::string thrown(std::size_t first, unsigned threads) {
  std::atomic<std::size_t> failures = 0;
  try {
    for_each_index(
        40,
        [&](std::size_t i) {
          if (i < first) return;
          while (i == first && threads > 1 && failures == 0) std::this_thread::yield();
          ++failures;
          throw std::runtime_error(std::to_string(i));
        },
        threads);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("of several items that fail, the first in order is the one that is heard of") {
  for (const std::size_t first : {0U, 7U, 38U}) {
    CHECK(thrown(first, 1) == std::to_string(first));
    CHECK(thrown(first, 3) == std::to_string(first));
  }
  CHECK(thrown(40, 3).empty());
}

TEST_CASE("processors may be held at a number, for as long as that is asked for") {
  const unsigned all = processors();
  {
    const HeldProcessors held(7);
    CHECK(processors() == 7);
  }
  CHECK(processors() == all);
}

#ifdef __linux__
TEST_CASE("a process that is bound to one processor has one") {
  cpu_set_t before;
  REQUIRE(sched_getaffinity(0, sizeof before, &before) == 0);
  CHECK(processors() == static_cast<unsigned>(CPU_COUNT(&before)));
  int first = 0;
  while (!CPU_ISSET(first, &before)) ++first;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
  CHECK(processors() == 1);
  REQUIRE(sched_setaffinity(0, sizeof before, &before) == 0);
}
#endif
