// What reading an output again tells of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline::compensate {

/// A line of a program. `file`: of a subprogram that it stands in; empty: the program's own.
struct SourceLine {
  std::size_t line = 0;
  std::string_view file = {};
};

/// The largest of something, and the line of the program where it was.
struct Worst {
  double value = 0;
  std::size_t line = 0;
  std::string file = {};  // as SourceLine has it

  void take(double candidate, const SourceLine& at) {
    if (candidate <= value) return;
    value = candidate;
    line = at.line;
    if (file != at.file) file = at.file;
  }
  void take(const Worst& other) { take(other.value, {other.line, other.file}); }
};

/// What the output says when it is read again.
struct ReadBackFigures {
  std::uint64_t blocks = 0;         // of the original that were held against it
  std::uint64_t output_blocks = 0;  // that were read
  std::uint64_t guard_lines = 0;    // which only the machine can decide, and were not
  std::uint64_t points = 0;         // ends of corrected moves and of their pieces
  double seconds = 0;               // of moves and dwells whose time the program sets
  Worst time_change;                // of any block, as a share of its time
  Worst rounding_mm;                // of a point against what was asked
};

}  // namespace plumbline::compensate
