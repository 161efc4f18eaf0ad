// A cycle written out: blocks of one motion each.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nc/control/state/control.hpp"
#include "nc/rewrite/output/emit_codes.hpp"
#include "nc/rewrite/output/emit_text.hpp"
#include "nc/rewrite/unrolled/made_steps.hpp"

namespace plumbline::nc {

class WrittenMoves {
 public:
  /// The dialect must outlive it. `increment_ratio` as in EmitSettings.
  WrittenMoves(const Dialect& dialect, double increment_ratio)
      : increment_ratio_(increment_ratio), dialect_(dialect), codes_(dialect), made_(dialect) {
    spelling_.point = dialect.behaviour.always_point;
    spelling_.most_digits = dialect.behaviour.most_digits;
  }

  /// A cycle as blocks of one motion each, in order: what else its block holds, its moves and dwells with G0, G1 and
  /// G4, and the words that act after the motion. Cycles that work the spindle keep one block a hole, with every word
  /// of it (Step::holes holds one entry). `anew`: a hole that keeps its block states the code of its cycle too, and
  /// what it takes over from the blocks before. `step` is one of StepExpander. Holds until the next call.
  std::span<const Step* const> of(const Step& step, bool anew = false);

  /// True of a block of a cycle that makes one hole, and says where it is as a position.
  static bool is_one_hole(const Step& step);

 private:
  void add(MadeStep& own);
  void add_rest(const Step& step);
  void add_words_after(const Step& step);
  void add_move(const Step& step, const Motion& motion);
  void add_moves(const Step& step, std::span<const Motion> motions);
  void add_hole(const Step& step, const Hole& hole);
  void add_called_hole(const Step& step, const Hole& hole);
  void add_hole_in_place(const Step& step, bool anew);
  void append_taken_over(std::string& text, const Step& step) const;

  void append_axis(std::string& text, const Step& step, char letter, double mm) const;
  double kept(const Step& step, Axis axis, double value) const;

  double increment_ratio_;
  const Dialect& dialect_;
  CodeWriter codes_;
  MadeSteps made_;
  BlockEditor editor_;
  Spelling spelling_;
  std::vector<const Step*> list_;       // what of() gives
  std::vector<MadeStep*> owned_;        // and who owns it
  MotionMode mode_ = MotionMode::none;  // of the moves written out so far
  std::string number_;                  // N of a cycle that holds nothing else
};

}  // namespace plumbline::nc
