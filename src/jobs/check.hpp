// A program against the limits of a machine.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "base/progress.hpp"
#include "jobs/expected/expected_error.hpp"
#include "jobs/simulate.hpp"
#include "machine/limits.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

struct CheckFinding {
  std::string file;              // that the block stands in: the program, or a subprogram beside it
  std::size_t line = 0;          // of the block
  machine::Violation violation;  // the worst of its kind in this block
  std::size_t left_by = 0;       // the line of the G53, G28 or G30 that left the axis there; 0: none
  std::string left_by_file;      // that it stands in, where that is another one
};

struct CheckSummary {
  std::uint64_t blocks = 0;
  std::uint64_t points = 0;                    // that were looked at
  std::uint64_t passed_moves = 0;              // in machine coordinates or to unknown positions: not looked at
  std::uint64_t violations = 0;                // one for each kind and block
  std::map<std::string, std::uint64_t> kinds;  // blocks for each kind: "tilt", "X", "strut 3", "condition", "reach"
  std::vector<CheckFinding> findings;          // the first kMostFindings
  std::optional<Diagnostic> refusal;           // of compensate, where all limits are kept
  Expectation expected;                        // at the tip, once it is compensated

  static constexpr std::size_t kMostFindings = 1000;
};

/// Checks the programmed poses (tilt) and the poses that compensation would command (tilt, travel, struts, condition)
/// at every point of the path; a pose that no command can reach is of the kind "reach". Refuses what
/// compensate::MoveReader refuses; what compensate refuses later, when it writes, is in the summary.
/// `picture`: the path as it would be commanded; null: none is wanted.
CheckSummary check_file(const Source& program, const settings::Options& options, const Progress& progress = {},
                        ProgramPicture* picture = nullptr);

}  // namespace plumbline::jobs
