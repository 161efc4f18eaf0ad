// What is said about a program besides its text: options, tables, the machine's own ways.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "base/axes.hpp"
#include "nc/control/state/tilt.hpp"
#include "nc/language/feed_rule.hpp"
#include "nc/language/rotary.hpp"
#include "nc/language/tool_table.hpp"

namespace plumbline::nc {

inline constexpr int kWorkSystems = 306;  // of any control; Dialect::work_systems says how many it has

struct WorkOffset {
  AxisWords origin;
  double rotation_deg = 0;

  bool operator==(const WorkOffset&) const = default;
};

inline constexpr double kOwnTiltDeg = 1e-6;  // from here on A or B of a program that no correction has tilted count

/// What the program's text alone does not say.
struct ProgramSettings {
  std::array<std::optional<WorkOffset>, kWorkSystems> work_offsets;
  ToolTable tools;
  std::optional<int> tool_in_spindle;              // at the start
  std::array<std::optional<double>, kAxes> start;  // where the axes stand at the start, in the first work system
  std::map<int, double> variables;                 // numbered parameters set before the program
  std::set<int> passed_m_codes;                    // --pass
  std::set<int> keeps_position;                    // --keeps-position, M codes
  std::optional<FeedRule> feed_rule;               // --feed-rule, in place of the dialect's
  std::optional<bool> helix_feed_along_circle;     // --helix-feed, in place of the dialect's
  RotaryRules rotary{};                            // --rotary, of A, B and C
  RotationOrder rotation_order{2, 1, 0};           // how A, B and C compose: of the machine's model
  FreeRotation free_rotation{};                    // --free-rotation, where a direction of the tool leaves C open
  std::optional<bool> inches;                      // --unit: what is in force at the start
  std::optional<bool> calculator_type;             // --calculator-type: a number without a point counts units
  std::optional<double> input_increment;           // --input-increment: what it counts, mm and deg
  double upright_deg = 0.1;                        // A and B below: of a correction, not of the program
  AxisSet named = AxisSet::all();                  // by some word of the program; the others are taken to stand at zero
  /// In place of upright_deg, where a corrected program is read beside its original: whether that tilted the tool where
  /// the next block changes its length (Step::tilted_length). Must outlive the reading.
  const bool* original_tilted = nullptr;
  std::uint64_t max_blocks = 10'000'000;  // --max-blocks: lines that a program with jumps may execute
  std::optional<bool> block_delete;       // --block-delete on|off
  /// Expressions may read where the axes are (#5001 and up of macro B): true for who only looks, since a rewritten
  /// program would read something else.
  bool position_may_be_read = false;
  /// trace alone: what was not given is what a control with empty tables has (zero), M codes of the user pass.
  bool as_with_empty_tables = false;
};

}  // namespace plumbline::nc
