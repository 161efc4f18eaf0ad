// What executing one block did: the hand-over from the interpreter to everything that looks at or rewrites programs.
#pragma once

#include <span>

#include "nc/block.hpp"
#include "nc/frame.hpp"
#include "nc/modal.hpp"
#include "nc/motion.hpp"

namespace plumbline::nc {

/// Why a block may not be rewritten as a plain move even though it holds axis words.
enum class BlockRole : std::uint8_t {
  plain,            // moves, modal codes, or nothing
  machine_move,     // G53, G28, G30: goes through as it stands
  sets_offset,      // G92, G10 L20: reads where the control stands; its axis words must make up for the shift
  cycle,            // G73, G81..G89: several moves of one block
  stores_position,  // G28.1, G30.1: stores where the control stands; cannot be made up for
};

/// M98 calls a program, M99 ends it.
struct ProgramCall {
  bool calls = false, ends = false;
  int number = 0;
  int count = 1;
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
  AxisSet named;                    // axes whose words stand in the block
  BlockRole role = BlockRole::plain;
  bool flow = false;             // the line steers the program: an O word, M98, M99
  bool polar = false;            // its end is given by @ and ^
  bool jumped = false;           // something jumped or repeated before: steps are not in the order of the text
  bool skipped = false;          // block delete is on for it: nothing of it was executed
  bool executed_delete = false;  // block delete is off for it, and it moves or changes modal state
  bool changes_tool = false;     // M6, M61
  bool loses_position = false;   // M0, M6, user M code, G28...: some axis may stand elsewhere now
};

}  // namespace plumbline::nc
