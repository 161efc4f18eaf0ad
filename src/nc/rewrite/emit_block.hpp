// One block of the output for each piece of a move.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nc/rewrite/emit_pieces.hpp"
#include "nc/rewrite/output/emit_codes.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {

/// Spells pieces: the first is the block itself with its words changed, the others hold what moves and no more.
class PieceWriter {
 public:
  explicit PieceWriter(const CodeWriter& codes) : codes_(codes) {}

  /// `codes`: of the step's block. `standing`: the motion mode that the control is in when the line begins.
  void append_first(std::string& out, const Step& step, const Piece& piece, const Spelling& spelling,
                    const BlockCodes& codes, MotionMode standing, bool is_last);
  /// The block with its words changed, where it is one line, no code of it changes and no word but F is added or left
  /// out: most blocks are so. Nothing where it is not. Holds until the next call.
  std::optional<std::string_view> in_place(const Step& step, const Piece& piece, const Spelling& spelling,
                                           const BlockCodes& codes, MotionMode standing, bool is_last);
  void append_further(std::string& out, const Step& step, const Piece& piece, const Spelling& spelling,
                      const BlockCodes& codes, MotionMode standing, bool is_last) const;

 private:
  std::string codes_before(const Step& step, const Piece& piece, const BlockCodes& codes, MotionMode standing,
                           bool is_last);
  const std::string& change_axis_words(const Step& step, const Piece& piece);
  static bool codes_stay(const Step& step, const Piece& piece, const BlockCodes& codes, MotionMode standing,
                         bool is_last);
  static void append_axis_word(std::string& out, const Piece& piece, Axis axis, const Spelling& spelling);
  void place_words(const Step& step, const Piece& piece, const std::string& codes_before, const std::string& words,
                   bool is_last);
  void change_feed_word(const Step& step, const Piece& piece);
  const CodeWriter& codes_;
  BlockEditor editor_;
  std::string added_;       // words that the block does not hold
  std::vector<char> line_;  // of in_place(): room that only grows
};

/// The first word of the block that names an axis; null if there is none.
const Word* first_axis_word(const Block& block);

}  // namespace plumbline::nc
