// What becomes of the programs of a folder.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"

namespace plumbline::jobs {

/// One of them.
struct BatchItem {
  enum class State {
    done,
    unchanged,    // what it was made from is as it was, and so is the output
    failed,       // refused
    subprogram,   // refused on its own, but others call it and hold what it does
    compensated,  // it holds corrections already: what it was made of is the program
  };

  std::string program;
  std::string output;
  State state = State::done;
  std::string summary;                  // one JSON object, as report::summary_json gives it; empty: refused
  std::vector<Diagnostic> diagnostics;  // the refusal, and warnings of this run
};

/// All of them.
struct BatchSummary {
  std::size_t done = 0;
  std::size_t unchanged = 0;
  std::size_t failed = 0;
  std::size_t subprograms = 0;
  std::size_t compensated = 0;           // programs that were so before
  std::vector<std::string> passed_over;  // files that are no programs
  std::vector<std::string> vanished;     // outputs whose program is gone
  std::vector<std::string>
      among_outputs;   // programs that lie in the folder of the outputs, which is in that of programs
  double seconds = 0;  // that it took
};

}  // namespace plumbline::jobs
