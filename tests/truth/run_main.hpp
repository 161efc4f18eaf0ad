// The end of the stand-in's programs.
#pragma once

#include <cstdio>
#include <exception>

namespace truth {

/// What `run` returns; 1, with its message on standard error, where it throws.
inline int run_main(int (*run)(int, char**), int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& problem) {
    std::fputs(problem.what(), stderr);
    std::fputc('\n', stderr);
    return 1;
  }
}

}  // namespace truth
