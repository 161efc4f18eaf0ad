// Reads a program as moves of the machine: with the tool that makes them, and what is known of where they go.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/files/files.hpp"
#include "base/progress.hpp"
#include "compensate/corrector.hpp"
#include "compensate/limits.hpp"
#include "compensate/move.hpp"
#include "nc/sequence/program_ahead.hpp"
#include "path/figures.hpp"
#include "path/subdivide.hpp"

namespace plumbline::compensate {

/// Length (G43) and load (M6) of the tool.
class SpindleTool {
 public:
  /// `tools` must outlive it. `reference_mass`: of a tool without a stated mass, kg.
  SpindleTool(const nc::ToolTable& tools, double reference_mass) : tools_(tools), reference_mass_(reference_mass) {}

  /// The tool, where the step brings another one; the first step always does.
  std::optional<ToolInSpindle> change(const nc::Step& step);
  /// False where the table does not give the mass of the tool that is in the spindle.
  bool has_mass() const { return has_mass_; }

 private:
  const nc::ToolTable& tools_;
  double reference_mass_;
  std::optional<AxisWords> offset_;
  int number_ = -1;
  bool has_mass_ = true;
};

/// What keeps a position from being known.
struct UnknownPosition {
  AxisSet moved;     // axes that were taken to stand at zero, and are moved here
  AxisSet missing;   // axes that no word said and nobody may take to stand at zero
  AxisSet turned;    // of these: no word names them, but the work offset turns them
  std::string stop;  // the block after which some of them may stand elsewhere, as in "M0 in line 3"; "": none known
  std::string stop_code;   // its M code, where it is one
  bool by_length = false;  // it changes the tool's length under a tilt
  bool no_system = false;  // no work system is in force at the start: --start says nothing

  bool none() const { return moved.empty() && missing.empty(); }
};

/// G1 F500 before the first move: no axis is named, and X, Y or Z may stand anywhere. Nothing moves.
bool sets_mode_alone(const nc::Step& step, const nc::Motion& motion);

/// Where the axes stand, and how to say it: "here", and the help of a refusal. `axes`: their names.
std::string where_unknown(const UnknownPosition& unknown);
std::string way_to_known(const UnknownPosition& unknown, std::string_view axes);

struct ReaderSettings {
  AxisSet named = AxisSet::all();  // axes that some word of the program names (nc::named_axes)
  path::StepSettings step;
  double reference_tool_mass = 0;  // kg
  AxisWords touch_off_error;       // that every pose gets
  bool as_it_stands = false;       // it may be a program that was corrected already
};

/// Axes that no correction of the step's motion may write.
inline AxisSet fixed_axes(const nc::Step& step, AxisSet at_zero) {
  return at_zero | (step.frame->tilted ? AxisSet::rotary() : AxisSet{});
}

/// The motion of a step as the machine makes it, in one piece. `at_zero`: axes that are taken to stand at zero.
Move move_of(const nc::Step& step, const nc::Motion& motion, const nc::Dialect& dialect, const ReaderSettings& settings,
             AxisSet at_zero);
/// Whether a curve leads to where the tool stands already, but for the last digits of an expression.
bool goes_nowhere(const path::Curve& curve);
/// Where it leads to where the tool stands already, but for the last digits of an expression, no F could keep its time:
/// that is forgotten.
void forget_time_of_no_way(Move& move);
/// Sets its pieces, at the step settings. Refuses with path-too-many-pieces.
void divide(Move& move, const path::StepSettings& settings);

/// Where the program tilts the tool at all, its tilts are its own.
nc::ProgramSettings settings_of_reading(nc::ProgramSettings program, const ReaderSettings& settings);

class MoveReader {
 public:
  /// All but `settings` must outlive it; `looks` is as of nc::ProgramAhead.
  MoveReader(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
             const ReaderSettings& settings, nc::StepsAhead* looks = nullptr)
      : source_(source),
        dialect_(dialect),
        settings_(settings),
        program_(source, dialect, settings_of_reading(program, settings), looks),
        spindle_(program.tools, settings.reference_tool_mass),
        keeps_position_(program.keeps_position) {
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
      if (program.start[index(axis)].value_or(0) != 0) away_.insert(axis);
    }
  }

  /// The next block of the program, as nc::Program gives it.
  const nc::Step* next();
  /// True once a block was read that does not come next in the text.
  bool jumped() const { return program_.jumped(); }
  bool position_read() const { return program_.position_read(); }
  /// The tool that makes the moves of the step, where it is another one than before.
  std::optional<ToolInSpindle> new_tool(const nc::Step& step) { return spindle_.change(step); }
  bool tool_has_mass() const { return spindle_.has_mass(); }
  /// What the blocks up to this one that go through as they stand left behind.
  const PassedMoves& passed() const { return passed_; }

  /// Whether a position of which the axes in `known` are known is known as a whole. Rotary axes that no word of the
  /// program names are taken to stand at zero from the first move on of which they are not known; not so where they
  /// stood elsewhere before.
  UnknownPosition unknown(const nc::Step& step, AxisSet known);
  /// The same of what a move needs: where it ends, and of one that cuts where it begins.
  UnknownPosition unknown(const nc::Step& step, const nc::Motion& motion) {
    const AxisSet known = path::is_cut(motion.kind) ? motion.known_after & motion.known_before : motion.known_after;
    const bool all = known == AxisSet::all() && (at_zero_ & step.named).empty();
    return all ? UnknownPosition{} : unknown(step, known);
  }

  /// A move of the step, or of one that was made of it, in one piece.
  Move move(const nc::Step& step, const nc::Motion& motion) const {
    Move move = move_of(step, motion, dialect_, settings_, at_zero_);
    if (step.block->file != source_.name()) move.path.file = step.block->file;
    return move;
  }
  void divide(Move& move) const { compensate::divide(move, settings_.step); }
  /// As nc::ProgramAhead has it.
  std::uint64_t handed_over() const { return program_.handed_over(); }
  std::size_t place() const { return program_.place(); }
  AxisSet writable(const nc::Step& step) const { return AxisSet::all() - fixed_axes(step, at_zero_); }

  /// For who leaves the program as it is: the next move, divided; those in machine coordinates, to
  /// unknown positions and probing moves are left out. Null at the end. Refuses with walk-position-unknown a move that
  /// cuts from or to where nobody knows, and one of an axis that was taken to stand at zero.
  const Move* next_move(const Progress& progress = {});
  /// The tool that makes this move, where it is another one than before.
  std::optional<ToolInSpindle> new_tool() { return std::exchange(changed_tool_, std::nullopt); }
  /// When this move begins, s since the start; rapids, and what G95 times, left out.
  double begin_s() const { return begin_s_; }
  std::uint64_t passed_moves() const { return passed_moves_; }

  std::uint64_t blocks() const { return blocks_; }
  /// Axes that are taken to stand at zero.
  AxisSet at_zero() const { return at_zero_; }

 private:
  // A block after which the axes that were known may stand elsewhere.
  struct Stop {
    AxisSet axes;
    std::string name, code;  // M0 and M0, or #3006 and M0
    std::size_t line = 0;
    std::string file;
    bool by_length = false;
  };

  void note_away(const nc::Step& step);
  void note_stop(const nc::Step& step);
  bool take(const nc::Motion& motion);

  const InputFile& source_;
  const nc::Dialect& dialect_;
  ReaderSettings settings_;
  nc::ProgramAhead program_;
  SpindleTool spindle_;
  std::set<int> keeps_position_;
  AxisSet at_zero_;
  AxisSet away_;   // rotary axes that are known to have stood elsewhere
  AxisSet gone_;   // that no word names, since the end of a swivelled plane
  AxisSet known_;  // after the block before
  Stop stop_;
  Stop swivel_;  // the last end of a swivelled plane: axes that no word names are lost by it alone
  PassedMoves passed_;
  std::uint64_t blocks_ = 0;

  // For next_move()
  const nc::Step* step_ = nullptr;
  std::size_t motion_ = 0;  // of the step, the next
  std::optional<Move> move_;
  std::optional<ToolInSpindle> changed_tool_;
  double begin_s_ = 0, end_s_ = 0;
  std::uint64_t passed_moves_ = 0;
};

}  // namespace plumbline::compensate
