// The same work for many items on all processors.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/platform/platform.hpp"

namespace plumbline {

/// As long as one lives, the libraries take the machine to have so many processors; not two at a time. For tests of
/// results that must not depend on it.
class HeldProcessors {
 public:
  explicit HeldProcessors(unsigned count) { held() = count; }
  HeldProcessors(const HeldProcessors&) = delete;
  HeldProcessors& operator=(const HeldProcessors&) = delete;
  ~HeldProcessors() { held() = 0; }

  /// None: as many as there are.
  static std::atomic<unsigned>& held() {
    static std::atomic<unsigned> count = 0;
    return count;
  }
};

/// How many threads a library uses when nobody says otherwise.
inline unsigned processors() {
  const unsigned held = HeldProcessors::held();
  return held > 0 ? held : platform::processors();
}

/// Calls work(i) for each i below `count`, on up to `threads` threads, fewer where the system has no more, in no order.
/// What depends on the order (sums) is for the caller to do afterwards, item by item, so that results do not depend on
/// the number of threads. Of the exceptions that calls throw, that of the least i is thrown again here; calls that have
/// not begun by then are left out.
template <class Work>
void for_each_index(std::size_t count, Work&& work, unsigned threads = processors()) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::size_t failed_at = count;  // all calls before it have begun, and one of them may throw as well
  std::mutex guard;
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::scoped_lock lock(guard);
        if (i < failed_at) {
          failed_at = i;
          failure = std::current_exception();
        }
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t t = 1; t < std::min<std::size_t>(threads, count); ++t) others.emplace_back(run);
    } catch (const std::system_error&) {  // no more of them: those that there are do it
    }
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace plumbline
