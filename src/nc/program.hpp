// A program, executed block by block: read, parsed, interpreted. Memory does not grow with its length.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "base/files.hpp"
#include "nc/dialect.hpp"
#include "nc/rotary.hpp"
#include "nc/step.hpp"
#include "nc/tilt.hpp"
#include "nc/tool_table.hpp"

namespace plumbline::nc {

inline constexpr int kWorkSystems = 306;  // of any control; Dialect::work_systems says how many it has

struct WorkOffset {
  AxisWords origin;
  double rotation_deg = 0;
};

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
  RotaryRules rotary{};                            // --rotary, of A, B and C
  RotationOrder rotation_order{2, 1, 0};           // how A, B and C compose: of the machine's model
  FreeRotation free_rotation{};                    // --free-rotation, where a direction of the tool leaves C open
  std::optional<bool> calculator_type;             // --calculator-type: a number without a point counts units
  std::optional<double> input_increment;           // --input-increment: what it counts, mm and deg
  std::uint64_t max_blocks = 10'000'000;           // --max-blocks: lines that a program with jumps may execute
  std::optional<bool> block_delete;                // --block-delete on|off
  /// Expressions may read where the control stands (#5420..., #<_x>...): true for who only looks, since a rewritten
  /// program would read something else.
  bool position_may_be_read = false;
  /// trace alone: what nobody gave is what a control with empty tables has (zero), M codes of the user pass.
  bool as_with_empty_tables = false;
};

/// Pulls a program through lexer, parser and interpreter.
class Program {
 public:
  /// `file` and `dialect` must outlive it.
  Program(const InputFile& file, const Dialect& dialect, ProgramSettings settings);
  ~Program();
  Program(Program&&) = delete;
  Program& operator=(Program&&) = delete;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Executes the next block; null at the end. As long as nothing jumped (Step::jumped) the texts of all blocks, with
  /// their line ends, put one after the other are the file. Refuses with nc-... and the place of what it cannot take,
  /// and at the end with file-changed where a file was written to meanwhile.
  const Step* next();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The axes that some word of the program names, or of a subprogram beside it that it calls by a plain name; found
/// without executing it. Files of subprograms are those of the dialect.
AxisSet named_axes(const InputFile& file, const Dialect& dialect);

}  // namespace plumbline::nc
