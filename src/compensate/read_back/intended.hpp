// What the output of a compensation is meant to do, block by block: made from the original program and its corrections,
// never from the text that is written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/axes.hpp"
#include "compensate/read_back/figures.hpp"
#include "nc/control/state/frame.hpp"
#include "nc/control/state/modal.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::compensate {

/// Something that a block does besides moving: M8, S1000, G43 H3, a comment.
struct BlockEffect {
  std::string text;                            // the code, or the letter of a value, or the comment
  std::vector<std::pair<char, double>> words;  // its values
  bool behind_motion = false;
  bool is_comment = false;
  bool is_mode = false;   // that may be said again where it comes back: M3, M8, G43
  std::uint8_t turn = 0;  // in the order of execution
};

/// Halves of what the control keeps: an axis without a word may be left that far off.
inline constexpr double kLoose = 1.6;

/// A move of the original, and where the control shall stand at its end, or at the ends of its pieces.
struct IntendedMove {
  enum class Form : std::uint8_t {
    kept,    // one move of the same kind
    pieces,  // moves through the points, in order: straight, or along arcs
  };
  Form form = Form::kept;
  nc::Motion motion;            // of the original
  std::size_t first_point = 0;  // in the batch; the control's display, mm and deg
  std::size_t points = 0;       // at least one
  std::size_t first_arc = 0;    // in the batch, one for each point; nothing there: straight
  bool has_arcs = false;
  double centre_tolerance = 0;    // of each word of their centres, mm
  AxisSet loose;                  // axes that get no word: they stand where they stood
  AxisWords tolerance;            // half of what the control keeps, mm and deg
  AxisWords digit, increment;     // of its words, in the program's unit: 0.0001; what the control keeps, or 0
  std::optional<double> seconds;  // that it shall take; revolutions under G95
  double time_share = 1;          // that is of what the original takes
  bool counts = true;             // its time is in the summary
  bool corrected = false;         // its points are in the summary
};

/// Modes and offsets in force after a block.
struct IntendedState {
  nc::Modal modal;
  nc::Frame frame;
};

struct IntendedBlock {
  std::size_t line = 0;          // of the original
  std::uint64_t offset = 0;      // of its first byte
  std::string file;              // that it stands in; empty: the program itself
  std::uint64_t output_end = 0;  // of its text in the output
  bool one_step = false;         // it is one block of the output, wherever that ends
  bool steers = false;           // a line of flow: nothing is left of it but modes that come back
  bool spindle_cycle = false;    // entered with a rapid more than the original has
  bool tilted_length = false;    // it changes the length of a tool that the original tilts
  bool left_out = false;         // block delete, or parameters alone: nothing is left but a comment
  std::string number;            // its N word
  std::size_t first_move = 0, moves = 0;
  std::size_t first_effect = 0, effects = 0;
  std::size_t state = 0;

  SourceLine place() const { return {line, file}; }
};

/// Blocks one after the other, with what they refer to. Reused.
struct IntendedBatch {
  std::uint64_t unchanged_blocks = 0;  // of the original that come first, as they stand
  std::vector<IntendedBlock> blocks;
  std::vector<IntendedMove> moves;
  std::vector<AxisWords> points;
  std::vector<std::optional<nc::Arc>> arcs;  // in the work system
  std::vector<BlockEffect> effects;
  std::vector<IntendedState> states;
  std::uint64_t output_size = 0;  // bytes that may be read
  bool last = false;

  void clear() {
    unchanged_blocks = 0;
    blocks.clear();
    moves.clear();
    points.clear();
    arcs.clear();
    effects.clear();
    states.clear();
    output_size = 0;
    last = false;
  }
};

}  // namespace plumbline::compensate
