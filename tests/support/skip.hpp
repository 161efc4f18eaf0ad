// A test that needs what is not here says so: ctest then counts it as skipped, and scripts/test says why.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace plumbline::testing {

/// To be followed by return. The line is what cmake/add_module.cmake and scripts/count_tests.py look for.
inline void skip(const std::string& reason) {
  std::printf("\nthis test is skipped: %s\n", reason.c_str());
  std::fflush(stdout);
}

/// True where LinuxCNC's interpreter is installed; else the test is skipped.
inline bool has_rs274_or_skips() {
  const bool has = std::system("command -v rs274 >/dev/null 2>&1") == 0;
  if (!has) skip("LinuxCNC's interpreter is not installed (scripts/setup --dev --with-oracle)");
  return has;
}

inline void skip_without_corpus() { skip("no programs of others: name their folder in PLUMBLINE_NC_CORPUS"); }

}  // namespace plumbline::testing
