// Always-on check of an invariant: a broken one is a bug of plumbline, never of its input.
#pragma once

#include <stdexcept>
#include <string>

namespace plumbline {

/// A broken invariant. Caught in main() alone, which says that this is a bug and exits.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void check_failed(const char* condition, const char* file, int line) {
  throw InternalError(std::string(file) + ":" + std::to_string(line) + ": check failed: " + condition);
}

}  // namespace plumbline

#define PLUMBLINE_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::plumbline::check_failed(#condition, __FILE__, __LINE__))
