// What executing one block did: the hand-over from the interpreter to everything that looks at or rewrites programs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nc/control/state/frame.hpp"
#include "nc/control/state/modal.hpp"
#include "nc/control/state/motion.hpp"
#include "nc/language/block.hpp"

namespace plumbline::nc {

struct CodeRow;

inline constexpr char kFeedOutLetter = '1';  // of FA=, as grammar/okuma.toml calls it

/// Why a block may not be rewritten as a plain move even though it holds axis words.
enum class BlockRole : std::uint8_t {
  plain,            // moves, modal codes, or nothing
  machine_move,     // G53, G28, G30: goes through as it stands
  sets_offset,      // G92, G10 L20: reads where the control stands; its axis words must make up for the shift
  cycle,            // G73, G81..G89: several moves of one block
  synchronised,     // G33, G33.1: the spindle leads
  stores_position,  // G28.1, G30.1: stores where the control stands; cannot be made up for
};

/// A variable, or texts and variables that << joins, in what is not looked into: what stands for it without variables.
struct PassedValue {
  Span span;
  std::string text;
};

/// What a line that steers the program enters: a subprogram, another pass of a loop, or nothing.
struct FlowEntry {
  enum class Kind : std::uint8_t { none, call, pass };
  Kind kind = Kind::none;
  std::string_view name;   // of the subprogram
  std::string_view file;   // that it stands in, if that is not the program's own
  std::size_t line = 0;    // of the call, or of where the loop begins
  std::uint64_t pass = 1;  // of a loop, or of M98 with L
};

/// What became of a block with "/" that moves or changes modal state.
enum class BlockDelete : std::uint8_t {
  none,      // not such a block
  left_out,  // block delete is on: nothing of the block was executed
  executed,  // block delete is off
};

/// A block that stops the control by setting a variable.
enum class StopByVariable : std::uint8_t {
  none,
  message,  // #3006=1: the program goes on
  alarm,    // #3000=1: the program ends
};

/// Whether a block changes the tool (M6, M61), and which tool makes its motion.
enum class ToolChange : std::uint8_t { none, before_motion, after_motion };

/// In which words a block gives where its move ends.
enum class EndWords : std::uint8_t {
  axes,
  polar,             // @ and ^
  tool_vector,       // the direction of the tool for A, B and C: by its words, or its code says that they follow
  angles_of_vector,  // A, B and C as they were written, rounded, in place of such a direction
};

/// A block of a NURBS curve (G5.2).
enum class NurbsBlock : std::uint8_t {
  none,
  point,  // its curve is moved along at the G5.3 after it
  end,    // G5.3
};

/// How a cycle may be rewritten.
enum class CycleForm : std::uint8_t {
  none,
  moves,    // G73, G81, G82, G83, G85, G89, and splines: its moves are all that it does
  spindle,  // G74, G84, G86 to G88: it works the spindle as well, so that it stays a cycle
};

/// A tool so near to where a cycle goes back to stands there, a correction apart; mm.
inline constexpr double kSameLevel = 0.1;

/// Two heights of a hole that are one; mm.
inline constexpr double kSameHeight = 1e-9;

/// One hole of a cycle, in the work system, mm; `first`, `second` and the normal are the axes of its plane.
/// The motions that it counts are those of the block of the program, also where a block of its own is made of it.
struct Hole {
  std::size_t approach_begin = 0, approach_end = 0;  // its motions: those to above the hole,
  std::size_t begin = 0, end = 0;                    // and those from R down and back
  int code = 0;                                      // of the cycle, as its row of the dialect says
  double first = 0, second = 0;
  double r = 0, bottom = 0, clear = 0;       // where it begins to feed, its end, where it goes back to
  const CodeRow* row = nullptr;              // of the cycle
  std::optional<double> dwell_s;             // P
  bool dwell_pointed = false;                // that it was written with a point
  double peck = 0, peck_to_r = 0;            // Q, or I and J of an OSP; mm
  double feed_out = 0;                       // FA of an OSP
  std::optional<std::array<double, 3>> ijk;  // G87: two of them beside the hole, that of the normal the level
};

struct CycleCall;
class HandedVariables;

/// M98 and G65 call a program, M97 a part of the one that is executed, M99 ends it.
struct ProgramCall {
  enum class Kind : std::uint8_t {
    none,
    program,  // M98
    part,     // M97: from the block with this N on
    macro,    // G65: the program has variables of its own
    end,      // M99
  };
  Kind kind = Kind::none;
  int number = 0;
  int count = 1;
  int whole = 0;                 // P00020003: 3 called twice, or 20003 where programs have eight digits; 0: no doubt
  std::optional<int> return_to;  // M99 P: the N at which the caller goes on

  bool calls() const { return kind != Kind::none && kind != Kind::end; }
  bool ends() const { return kind == Kind::end; }
};

/// Everything points into the interpreter and holds until the next block is executed.
struct Step {
  const Block* block = nullptr;
  std::span<const Motion> motions;  // none for most blocks without axis words; G28 through a point makes two
  const Modal* before = nullptr;    // the modal state that the block found
  const Modal* after = nullptr;     // and the one it left, in force for its own motion
  const Frame* frame = nullptr;     // the offsets in force for its motion and after it
  AxisWords position;               // where the axes stand after it, in the work system that is then active
  AxisSet known;                    // of which this is known
  AxisSet shifted;                  // whose increments may bring along an offset that changed before
  AxisSet named;                    // axes whose words stand in the block
  AxisSet new_place;  // of these those that a turn of the coordinates had left: a control needs their words
  BlockRole role = BlockRole::plain;
  double offset_rotation_deg = 0;  // sets_offset: of the work system that its words are in, active or not
  BlockDelete block_delete = BlockDelete::none;
  StopByVariable stop = StopByVariable::none;
  std::optional<FlowEntry> flow = {};     // the line steers the program: an O word, M98, M99 that ends a subprogram
  bool saves_modes = false;               // M70 to M73: modes are kept or come back
  std::optional<bool> g92_restored = {};  // by that: the shift of G92 came back into force, or went out of it
  CycleForm cycle = CycleForm::none;
  std::span<const Hole> holes = {};  // of a cycle
  const CycleCall* call = nullptr;   // that made its hole
  NurbsBlock nurbs = NurbsBlock::none;
  std::optional<Orienting> orienting = {};  // it turns the tool along a direction (G53.1)
  EndWords end_words = EndWords::axes;
  ToolChange tool_change = ToolChange::none;
  /// In the brackets of a name, which are not looked into; null: none.
  std::shared_ptr<const std::vector<PassedValue>> passed = {};
  bool passes_variables = false;            // of some more of them no value can be written in their place
  bool sets_kept_variable = false;          // one that other programs may read, or the control obeys: #500, #3004
  const HandedVariables* handed = nullptr;  // at the end of the program
  bool tilted_length = false;               // it changed the length of a tool that the program tilts
  bool loses_position = false;              // M0, M6, user M code, G28...: some axis may stand elsewhere now
};

/// G4 P1 X5: the control waits, then moves; the wait is the first of the motions.
inline bool dwells_first(const Step& step) {
  return step.motions.size() > 1 && step.motions.front().kind == MotionKind::dwell;
}
/// G4 P1: the control waits, and that is all.
inline bool dwells_alone(const Step& step) {
  return step.motions.size() == 1 && step.motions.front().kind == MotionKind::dwell;
}

}  // namespace plumbline::nc
