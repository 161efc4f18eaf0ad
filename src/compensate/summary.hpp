// What a compensation did, for the one who runs the program.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/axes.hpp"
#include "base/diagnostic.hpp"
#include "compensate/read_back/figures.hpp"
#include "nc/language/tool_table.hpp"

namespace plumbline::compensate {

/// Pieces that a control may not read fast enough.
struct ShortPieces {
  std::uint64_t below_1_ms = 0;
  std::uint64_t below_block_time = 0;  // that the model states
  std::uint64_t whole_blocks = 0;      // of these: the block of the program itself is as short
  double least_s = std::numeric_limits<double>::infinity();
  std::size_t line = 0;   // of the shortest
  std::string file = {};  // as SourceLine has it
};

/// Pieces on which a bound that was asked for is not kept.
struct BrokenBound {
  std::uint64_t pieces = 0;
  double seconds = 0;  // that they take
  Worst off_mm, off_deg;

  void add(const BrokenBound& other) {
    pieces += other.pieces;
    seconds += other.seconds;
    off_mm.take(other.off_mm);
    off_deg.take(other.off_deg);
  }
};

/// How far the deformed tip is off the path, as the proof of each piece says it, rounding included.
struct BoundOfMove {
  double kept_mm = 0, kept_deg = 0;  // where the bound is kept: the largest
  BrokenBound at_turns;              // where friction turns: the tip jumps, and no command does
  BrokenBound by_time;               // where the control's time for a block allows no point
};

/// What became of the arcs of a program where a bound chose the points.
struct ArcFigures {
  std::uint64_t stayed = 0;    // one arc each, as it stood or with other words
  std::uint64_t split = 0;     // several blocks, arcs among them
  std::uint64_t straight = 0;  // straight pieces alone
  std::uint64_t blocks = 0;    // of the output for those that are split
  Worst most_blocks;           // for one of these
};

/// The same of a program.
struct BoundFigures {
  Worst kept_mm, kept_deg;
  BrokenBound at_turns, by_time;
  ArcFigures arcs;
};

/// What an output was made of, and holds for.
struct MadeOf {
  struct Offset {
    std::string system;  // as the control calls it
    AxisWords origin;
    double rotation_deg = 0;
  };
  std::string program;
  std::uint64_t program_hash = 0;  // fnv1a, where Summary::hash_after is one
  std::string dialect;
  std::string model;
  std::string model_file;
  std::uint64_t model_hash = 0;
  std::vector<Offset> offsets;  // that were given, whether the program uses them or not
  std::vector<nc::Tool> tools;  // that it may use
};

struct Summary {
  MadeOf made_of;
  std::uint64_t blocks = 0;  // of the program
  std::uint64_t moves = 0;   // that were corrected or found to need no correction
  std::uint64_t changed_blocks = 0;
  std::uint64_t passed_moves = 0;  // that went through as they stand: machine coordinates, unknown position
  std::uint64_t points = 0;        // of the output
  Worst correction_mm;             // of the tool tip, X Y Z together
  Worst correction_deg;            // of the orientation, the largest of A, B, C
  double rms_correction_mm = 0;    // over the points
  double seconds_before = 0;       // of the moves whose time the program sets; G0 and G95 left out
  double seconds_after = 0;
  std::uint64_t untimed_moves = 0;   // that cut, and take what the program alone does not say: G95, strokes of a cycle
  Worst time_change;                 // of any block, as a share of its time
  Worst rounding_mm;                 // of a point: what the control keeps against what was asked
  Worst residual_mm;                 // of the deformed tip from the programmed path, between the written points as well
  Worst residual_deg;                // of its orientation
  std::uint64_t replayed = 0;        // points that were played on the model for that
  Worst condition;                   // condition number of the Jacobian at the points that were played
  std::uint64_t widened_blocks = 0;  // whose pieces the control's block time made longer
  Worst widened_step_mm;
  Worst widening_mm;  // that the tip leaves its path by between the points of such blocks
  ShortPieces short_pieces;
  std::optional<BoundFigures> bound;                                         // where the points were chosen by one
  double offset_shift_for_1um_mm = std::numeric_limits<double>::infinity();  // of the work offset, that costs 1 um
  std::optional<AxisWords> zero_error;  // dT at the first cutting block: what a work offset probed there holds already
  std::size_t zero_error_line = 0;
  std::string zero_error_file;  // as SourceLine has it
  AxisSet assumed_at_zero;      // rotary axes that the program never names
  std::uint64_t bytes_before = 0;
  std::uint64_t bytes_after = 0;
  std::uint64_t hash_after = 0;  // fnv1a of the output, where a file of the summary, an undo file or a caller takes it
  bool identical = true;         // nothing had to change
  bool unrolled = false;         // written as a program without loops, subprograms and parameters
  struct InlinedFile {
    std::string name;
    std::uint64_t hash = 0;
  };
  std::vector<InlinedFile> inlined_files;    // of subprograms that stand in the output now
  std::optional<ReadBackFigures> read_back;  // nothing: it was not, or the output is the input
  std::vector<Diagnostic> warnings;
};

}  // namespace plumbline::compensate
