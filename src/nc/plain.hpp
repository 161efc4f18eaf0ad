// Steps as a program would hold them that has no parameters, no polar words and no cycles: the same motion, written
// out.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "nc/control.hpp"
#include "nc/emit_codes.hpp"
#include "nc/emit_text.hpp"
#include "nc/parser.hpp"
#include "nc/step.hpp"

namespace plumbline::nc {

class PlainSteps {
 public:
  /// The dialect must outlive it.
  explicit PlainSteps(const Dialect& dialect, double increment_ratio = 1)
      : increment_ratio_(increment_ratio), dialect_(dialect), codes_(dialect), parser_(dialect) {
    spelling_.point = dialect.habits.always_point;
    spelling_.most_digits = dialect.habits.most_digits;
  }

  /// The step with a block that holds values where the original has expressions, and X and Y in place of @ and ^.
  /// Values come with nine decimals, and count as written with none. Its parameter settings go too unless
  /// `keeps_settings`; null if nothing else was in it. Holds until the next call. Refuses a value that only the machine
  /// knows (emit-value-unknown).
  const Step* plain(const Step& step, bool keeps_settings);

  /// What moves in a block that calls a program as well, or ends one. Holds until the next call.
  const Step* without_call(const Step& step);

  /// A cycle as blocks of one motion each, in order: what else its block holds, its moves and dwells with G0, G1 and
  /// G4, and the words that act behind the motion. Cycles that work the spindle keep one block a hole, with every word
  /// of it (Step::holes holds one entry). `step` is one of plain(). Holds until the next call of either.
  std::span<const Step* const> moves(const Step& step);

  /// True of a block of a cycle that makes one hole, and says where it is as a position.
  static bool is_one_hole(const Step& step);

 private:
  struct Own {
    std::string text;
    Block block;
    Modal before, after;
    Motion motion;
    Hole hole;
    Step step;
  };
  std::string with_value(std::string_view text, const Word& word) const;
  void write_values(const Step& step, bool keeps_settings);
  void write_polar_end(const Step& step, bool& written, Span span);
  void defuse_comments(const Block& block);
  Own& next_own(const Step& like);
  void parse(Own& own, const Step& like);
  void add(Own& own);
  void add_rest(const Step& step);
  void add_words_behind(const Step& step);
  void add_move(const Step& step, const Motion& motion);
  void add_hole(const Step& step, const Hole& hole);
  void add_called_hole(const Step& step, const Hole& hole);
  void add_hole_in_place(const Step& step);

  Span label_of(const Block& block) const;
  void append_dwell(std::string& text, double seconds) const;
  void append_axis(std::string& text, const Step& step, char letter, double mm) const;

  double kept(const Step& step, Axis axis, double value) const;

  double increment_ratio_;  // EmitSettings
  const Dialect& dialect_;
  CodeWriter codes_;
  Parser parser_;
  BlockEditor editor_;
  Spelling spelling_;
  std::deque<Own> own_;
  std::size_t used_ = 0;
  std::vector<const Step*> list_;       // what moves() gives
  std::vector<Own*> made_;              // and who owns it
  MotionMode mode_ = MotionMode::none;  // of the moves written out so far
  std::string number_;                  // N of a cycle that holds nothing else
};

}  // namespace plumbline::nc
