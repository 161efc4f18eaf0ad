// Writes a program again with its moves corrected: what need not change comes out byte for byte.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/files.hpp"
#include "nc/control/state/control.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/emit_block.hpp"
#include "nc/rewrite/emit_pieces.hpp"
#include "nc/rewrite/output/emit_codes.hpp"
#include "nc/rewrite/output/emit_state.hpp"
#include "nc/rewrite/output/emit_text.hpp"
#include "nc/rewrite/output/output_text.hpp"
#include "nc/rewrite/output/undo.hpp"
#include "nc/rewrite/unrolled/entry_comments.hpp"

namespace plumbline::nc {

/// What became of one move.
struct EmittedMove {
  bool changed = false;
  int pieces = 1;                 // blocks that it became
  std::optional<double> seconds;  // that the control takes for them; revolutions under G95
  double rounding_mm = 0;         // largest distance between a point as the control keeps it and as it was asked
  bool reworded = false;          // for a direction said in A, B and C alone, not for a correction
};

enum class Form : std::uint8_t {
  in_text_order,  // the source with its changed blocks replaced: the steps come in the order of the text
  unrolled,       // every block as it is executed, without parameters: no line of it steers
};

/// The comment that stands for a block in which every axis stands already.
inline constexpr std::string_view kAllStand = "every axis of this block stands there already";

/// The rules that it keeps are numbered in docs/rewriting.md: 3, 5, 13-19.
class Emitter {
 public:
  /// All must outlive it. `source` is the file that the steps come from. Unrolled, the steps are those of StepExpander
  /// and WrittenMoves.
  Emitter(const InputFile& source, const Dialect& dialect, EmitSettings settings, OutputFile& out,
          Form form = Form::in_text_order);

  /// Notes what the output replaces; to be called before the first block. `log` must outlive the emitter.
  void record(UndoLog& log) { text_.record(log); }

  /// From here on what is written does not matter, only whether changed(): the steps left the order of the text.
  void only_look() { text_.only_look(); }

  /// Unrolled: a line that steers the program, or keeps or restores modes. A comment says what is entered; modes that
  /// come back are written as the codes that bring them back. Refuses with emit-modes.
  void steer(const Step& step);

  /// True if a move through `points` may stay as it stands.
  bool stays(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable) {
    return planner_.words().stays(step, points, writable, control_);
  }
  /// True if a shift is none as the words of the block are written.
  bool rounds_to_zero(const Step& step, const AxisWords& shift, AxisSet writable) const {
    return planner_.words().rounds_to_zero(step, shift, writable);
  }
  /// True if the control stands where the original has it, as far as it can tell.
  bool stands_true(const Step& step, AxisSet writable) const {
    return planner_.words().rounds_to_zero(step, control_.work_shift(*step.frame), writable);
  }

  /// How the arc that is the step's move may be written as arcs; nothing: not at all.
  std::optional<ArcForm> arc_form(const Step& step) const {
    return nc::arc_form(dialect_, planner_.words(), step, control_);
  }
  /// What rounding may take off a word of the step's move, or put on it: mm and deg. Half of what the control keeps; of
  /// an axis that stands between two such numbers, and may be left there, three quarters.
  AxisWords half_quanta(const Step& step) const { return planner_.words().half_quanta(step, control_); }

  /// What is written between these two stands for the block of `step`.
  void begin_group(const Step& step);
  void end_group(const Step& step);

  /// A hole of a cycle that stays one (WrittenMoves::of), shifted by `shift` in X, Y and Z, in mm of the work system.
  EmittedMove hole(const Step& step, const AxisWords& shift);

  /// Unrolled: a block that moves nothing and stands for none of the original, before that of `step`.
  void add_line(const Step& step, const std::string& line);

  /// Passes a block through: no correction. Its axis words are changed only where they tell the control where it
  /// stands (G92), so that it ends with the offset that the original gives. Refuses with emit-stores-position.
  void copy(const Step& step);

  /// Writes the one move of a block through `points`, the last of them its end. Only axes in `writable` get words.
  /// `seconds`: what the block takes in the original; nothing for rapids. Refuses with emit-feed-rule,
  /// emit-line-too-long, emit-rotary-word and emit-shared-words.
  EmittedMove move(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                   std::optional<double> seconds);

  /// The same, where words that round the end of the original take the place of its own: its F is looked at, though no
  /// correction moves anything.
  EmittedMove rewrite(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                      std::optional<double> seconds);

  /// Unrolled, after the last block: what stands from here to the end of the source, as it is.
  void carry_over(std::uint64_t begin) { text_.carry_over(begin); }

  /// To be called after the last block. A program with no changed block comes out identical, without a stamp.
  void finish() { text_.finish(); }

  /// What the last move() that changed something became.
  const PiecePlanner& pieces() const { return planner_; }

  bool changed() const { return text_.changed(); }
  /// Where the lines of the guard stand in the output; empty as long as they were not written.
  std::pair<std::uint64_t, std::uint64_t> guard_span() const { return text_.guard_span(); }
  const OutputState& control() const { return control_; }
  const std::vector<InlinedFile>& inlined() const { return entries_.inlined(); }

 private:
  void follow(const Step& step);
  void begin_change(const Step& step);
  void note_cycle_level(const Step& step);
  void restore_feed_state(const Step& step, bool has_feed_word);
  std::string_view spell(const Step& step, std::size_t i, const BlockCodes& codes);
  void add_offset_shifts(const Step& step);
  void hold_changed(const Step& step, bool merges);
  void leave_out(const Step& step);
  void end_modal_call(const Step& step);
  EmittedMove called_hole(const Step& step, const AxisWords& shift);

  const Dialect& dialect_;
  EmitSettings settings_;
  OutputText text_;
  OutputState control_;
  PiecePlanner planner_;
  CodeWriter codes_;
  PieceWriter writer_;
  EntryComments entries_;
  double cycle_level_shift_ = 0;  // mm
  AxisWords tool_;                // length that the output has in force
  Spelling spelling_;
  BlockEditor editor_;
  std::string line_;
};

}  // namespace plumbline::nc
