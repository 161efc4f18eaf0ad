// The codes of a block by what they do, and the codes that a dialect writes for a state.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nc/control/state/modal.hpp"
#include "nc/control/step.hpp"
#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {

/// Words of one block; null where it has none of that kind.
struct BlockCodes {
  const Word* motion = nullptr;        // G0 to G3, G80
  const Word* feed_mode = nullptr;     // G93, G94, G95
  const Word* path_control = nullptr;  // G61, G61.1, G64
  const Word* feed = nullptr;          // F
  const Word* modal_call = nullptr;    // MCALL
  const Word* axis_taker = nullptr;    // G43.1: the axis words are its own, too
  const Word* other_taker = nullptr;   // of the same words: G10 L20 beside G43.1

  /// M0, M2...: executed once the motion is done.
  std::span<const Word* const> after_motion() const { return std::span(after_).first(after_count_); }
  void add_after_motion(const Word& word);

 private:
  std::array<const Word*, 16> after_{};
  std::size_t after_count_ = 0;
};

/// G64 P makes one line of moves that stay within Q of it, which is P where no Q stands: what corrections ask for in
/// between would be left away [LinuxCNC, emccanon.cc, linkable]. True of a block that sets such a mode.
bool merges_points(const Step& step, const BlockCodes& codes);
/// Q0 in that block: each point counts.
void keep_each_point(BlockEditor& editor, const Block& block);

class CodeWriter {
 public:
  explicit CodeWriter(const Dialect& dialect);

  BlockCodes codes_of(const Block& block) const;
  std::string_view motion(MotionMode mode) const { return motion_[static_cast<std::size_t>(mode)]; }
  std::string_view feed_mode(FeedMode mode) const { return feed_mode_[static_cast<std::size_t>(mode)]; }
  std::string_view path_control(PathControl control) const { return path_control_[static_cast<std::size_t>(control)]; }
  std::string_view dwell() const { return dwell_; }
  /// Of the word that holds the seconds of a dwell.
  char dwell_letter() const { return dwell_letter_; }
  /// The name of the code that does this.
  std::string_view name_of(Action action) const;
  /// True of a code that calls a cycle with values in brackets.
  bool is_call(const Word& word) const;
  std::string_view distance(bool incremental) const { return distance_[incremental ? 1 : 0]; }
  std::string cycle(int value) const { return text_of("cycle", value); }
  /// The code that means this; of several the one with that value.
  std::string text_of(std::string_view meaning, std::optional<int> value = std::nullopt) const;
  /// True of a code of the group of motions.
  bool is_motion(const Word& word) const;
  /// True if a code of the block other than its motion takes this letter.
  bool other_code_takes(const Block& block, char letter) const;

 private:
  const CodeRow* row_of(const Word& word) const;
  const Dialect& dialect_;
  std::array<std::string, 7> motion_;
  std::array<std::string, 3> feed_mode_;
  std::array<std::string, 3> path_control_;
  std::string dwell_;
  char dwell_letter_ = 'P';
  std::array<std::string, 2> distance_;
};

}  // namespace plumbline::nc
