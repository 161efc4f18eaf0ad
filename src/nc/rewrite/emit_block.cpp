#include "nc/rewrite/emit_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"

namespace plumbline::nc {
namespace {

bool is_axis_letter(char letter) { return axis_of(letter).has_value(); }

void append_centre(std::string& out, const ArcWords& arc, std::size_t i, const Spelling& spelling) {
  append_word(out, arc.letters[i], arc.value[i], arc.digits[i], spelling);
}

// In place of a word that gives the arc of the block: R makes way for both words of the centre, and so does one of
// these where the block lacks the other.
void append_centre_for(std::string& out, const Block& block, const Word& word, const ArcWords& arc,
                       const Spelling& spelling) {
  const bool both = find_word(block, arc.letters[0]) == nullptr || find_word(block, arc.letters[1]) == nullptr;
  for (std::size_t i = 0; i < 2; ++i) {
    if (both || word.letter == arc.letters[i]) append_centre(out, arc, i, spelling);
  }
}

// The word gives the centre as it is, and the block has the other one.
bool says_already(const Block& block, const Word& word, const ArcWords& arc) {
  if (word.mode != WordMode::modal) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    const bool same = word.letter == arc.letters[i] && std::abs(word.value - arc.value[i]) < 1e-12;
    if (same) return find_word(block, arc.letters[1 - i]) != nullptr;
  }
  return false;
}

// C-0 turns another way than C0.
bool says_already(const Word& word, const Piece& piece, Axis axis) {
  const bool other_way = piece.endless.contains(axis) && std::signbit(word.value) != std::signbit(piece.value[axis]);
  return word.mode == WordMode::modal && !other_way && std::abs(word.value - piece.value[axis]) < 1e-12;
}

bool is_arc_letter(char letter) {
  return letter == 'I' || letter == 'J' || letter == 'K' || letter == 'R' || (letter >= '1' && letter <= '3');
}

}  // namespace

const Word* first_axis_word(const Block& block) {
  for (const Word& word : block.words) {
    if (is_axis_letter(word.letter)) return &word;
  }
  return nullptr;
}

// Codes that must stand before the axis words: feed mode, exact stop, and the motion code where the control is in
// another one. Those that the block holds already are changed in place.
std::string PieceWriter::codes_before(const Step& step, const Piece& piece, const BlockCodes& codes,
                                      MotionMode standing, bool is_last) {
  const Spelling& spelling = editor_.spelling();
  std::string before;
  const FeedMode feed_mode = piece.leaves_inverse_time ? FeedMode::per_minute : step.after->feed_mode;
  if (codes.feed_mode != nullptr) {
    if (piece.leaves_inverse_time)
      editor_.replace(codes.feed_mode->span, in_spelling(codes_.feed_mode(feed_mode), spelling));
  } else if (piece.restates_mode) {
    append_code(before, codes_.feed_mode(feed_mode), spelling);
  }
  if (!is_last && step.after->path_control == PathControl::exact_stop) {
    if (codes.path_control != nullptr) {
      editor_.replace(codes.path_control->span, in_spelling(codes_.path_control(PathControl::exact_path), spelling));
    } else {
      append_code(before, codes_.path_control(PathControl::exact_path), spelling);
    }
  }
  const MotionMode mode = piece.mode(step);
  if (codes.motion != nullptr) {
    if (step.after->motion != mode) editor_.replace(codes.motion->span, in_spelling(codes_.motion(mode), spelling));
  } else if (standing != mode) {
    append_code(before, codes_.motion(mode), spelling);
  }
  return before;
}

// The block itself, its words changed; what runs after the motion waits for the last piece.
void PieceWriter::append_first(std::string& out, const Step& step, const Piece& piece, const Spelling& spelling,
                               const BlockCodes& codes, MotionMode standing, bool is_last) {
  const Block& block = *step.block;
  editor_.start(block, spelling);
  drop_slash(editor_, step);
  if (merges_points(step, codes)) keep_each_point(editor_, block);
  for (const Span& span : block.left_out) editor_.replace(span, "");  // the words added may be of the same letter
  const std::string before = codes_before(step, piece, codes, standing, is_last);
  place_words(step, piece, before, change_axis_words(step, piece), is_last);
  change_feed_word(step, piece);
  if (!is_last) {
    for (const Word* word : codes.after_motion()) editor_.replace(word->span, "");
  }
  editor_.apply(out);
}

// As codes_before() and append_first() have it.
bool PieceWriter::codes_stay(const Step& step, const Piece& piece, const BlockCodes& codes, MotionMode standing,
                             bool is_last) {
  if (!is_last && (!codes.after_motion().empty() || step.after->path_control == PathControl::exact_stop)) return false;
  const MotionMode mode = piece.mode(step);
  const bool feed_mode_stays = codes.feed_mode != nullptr ? !piece.leaves_inverse_time : !piece.restates_mode;
  const bool motion_stays = (codes.motion != nullptr ? step.after->motion : standing) == mode;
  return feed_mode_stays && motion_stays;
}

std::optional<std::string_view> PieceWriter::in_place(const Step& step, const Piece& piece, const Spelling& spelling,
                                                      const BlockCodes& codes, MotionMode standing, bool is_last) {
  const Block& block = *step.block;
  const bool plain = !piece.direct && step.motions.front().kind != MotionKind::arc && !block.words.empty() &&
                     step.block_delete == BlockDelete::none && block.left_out.empty() &&
                     block.text.find('\n') == std::string_view::npos && !merges_points(step, codes);
  if (!plain || !codes_stay(step, piece, codes, standing, is_last)) return std::nullopt;
  if (const std::size_t room = block.text.size() + (block.words.size() + 1) * kWordRoom; line_.size() < room)
    line_.resize(room);
  char* out = line_.data();
  std::uint32_t at = 0;
  const auto keep_up_to = [&](std::uint32_t end) {
    out = std::copy(block.text.begin() + at, block.text.begin() + end, out);
    at = end;
  };
  if (!piece.positioned.empty()) return std::nullopt;
  AxisSet seen;
  const Word* feed = nullptr;
  std::uint32_t words_end = 0;
  for (const Word& word : block.words) {
    words_end = std::max(words_end, word.span.end);
    const std::optional<Axis> axis = axis_of(word.letter);
    if (axis ? seen.contains(*axis) : word.letter != 'F' || feed != nullptr) continue;
    if (word.span.begin < at) return std::nullopt;  // not in the order of the text
    if (axis) {
      seen.insert(*axis);
      if (piece.endless.contains(*axis) && !piece.moved.contains(*axis)) return std::nullopt;
      if (says_already(word, piece, *axis)) continue;
      keep_up_to(word.span.begin);
      out = write_word(out, letter(*axis), piece.value[*axis], piece.digits[index(*axis)], spelling);
    } else {
      feed = &word;
      if (!piece.feed || word.value == *piece.feed) continue;
      keep_up_to(word.span.begin);
      out = write_word(out, 'F', *piece.feed, kMostDecimals, spelling);
    }
    at = word.span.end;
  }
  if (!seen.contains(piece.moved)) return std::nullopt;
  if (piece.feed && feed == nullptr) {
    if (words_end < at) return std::nullopt;
    keep_up_to(words_end);
    if (spelling.spaced && !is_blank(block.text[words_end - 1])) *out++ = ' ';
    out = write_word(out, 'F', *piece.feed, kMostDecimals, spelling);
  }
  keep_up_to(static_cast<std::uint32_t>(block.text.size()));
  return std::string_view(line_.data(), static_cast<std::size_t>(out - line_.data()));
}

void PieceWriter::append_further(std::string& out, const Step& step, const Piece& piece, const Spelling& spelling,
                                 const BlockCodes& codes, MotionMode standing, bool is_last) const {
  if (piece.restates_mode) {
    append_code(out, codes_.feed_mode(piece.leaves_inverse_time ? FeedMode::per_minute : step.after->feed_mode),
                spelling);
  }
  if (is_last && step.after->path_control == PathControl::exact_stop) {
    append_code(out, codes_.path_control(PathControl::exact_stop), spelling);
  }
  if (piece.mode(step) != standing) append_code(out, codes_.motion(piece.mode(step)), spelling);
  for (const Axis axis : kAllAxes) {
    if (piece.moved.contains(axis)) {
      append_axis_word(out, piece, axis, spelling);
    }
  }
  if (piece.arc) {
    for (std::size_t i = 0; i < 2; ++i) append_centre(out, *piece.arc, i, spelling);
  }
  if (piece.feed) append_word(out, 'F', *piece.feed, kMostDecimals, spelling);
  if (!is_last) return;
  for (const Word* word : codes.after_motion()) append_code(out, step.block->at(word->span), spelling);
}

void PieceWriter::append_axis_word(std::string& out, const Piece& piece, Axis axis, const Spelling& spelling) {
  const std::size_t begin = out.size();
  append_word(out, letter(axis), piece.value[axis], piece.digits[index(axis)], spelling);
  const bool direct = piece.direct && piece.endless.contains(axis);
  if (!direct && !piece.positioned.contains(axis)) return;
  const std::size_t value = out.find_first_not_of(' ', begin) + 1;
  out.insert(value, direct ? "=DC(" : "=AC(");
  out += ')';
}

// Words that stand in the block get their new values; gives the ones that must be added.
const std::string& PieceWriter::change_axis_words(const Step& step, const Piece& piece) {
  added_.clear();
  const Spelling& spelling = editor_.spelling();
  const Spelling alone{spelling.lower_case, false, spelling.point, spelling.most_digits};
  const std::array<const Word*, kAxes> words = axis_words(*step.block);
  for (const Axis axis : kAllAxes) {
    const Word* const word = words[index(axis)];
    const bool moves = piece.moved.contains(axis);
    if (word == nullptr) {
      if (moves) append_axis_word(added_, piece, axis, spelling);
      continue;
    }
    if (!moves && piece.endless.contains(axis)) {
      editor_.replace(word->span, "");
      continue;
    }
    const bool says_direct = piece.direct && piece.endless.contains(axis);
    if (says_already(*word, piece, axis) && !says_direct) continue;
    append_axis_word(editor_.replace(word->span), piece, axis, alone);
  }
  return added_;
}

void PieceWriter::place_words(const Step& step, const Piece& piece, const std::string& codes_before,
                              const std::string& words, bool is_last) {
  const bool arc = step.motions.front().kind == MotionKind::arc;
  if (codes_before.empty() && words.empty() && !arc) return;
  const Block& block = *step.block;
  const Word* first_axis = first_axis_word(block);
  const Word* last_axis = first_axis;
  std::string both = codes_before;
  if (!both.empty() && !words.empty() && editor_.spelling().spaced) both += ' ';
  both += words;
  for (const Word& word : block.words) {
    if (is_axis_letter(word.letter)) last_axis = &word;
    const bool of_arc =
        arc && (is_arc_letter(word.letter) || (word.letter == 'P' && !codes_.other_code_takes(block, 'P')));
    if (!of_arc) continue;
    if (word.letter == 'P' && piece.arc && is_last) continue;  // the arc as a whole keeps its turns
    const bool keeps = piece.arc && says_already(block, word, *piece.arc);
    if (keeps && (first_axis != nullptr || both.empty())) continue;
    std::string text;
    if (first_axis == nullptr) append_in_spelling(text, std::exchange(both, {}), editor_.spelling());
    if (piece.arc && word.letter != 'P') append_centre_for(text, block, word, *piece.arc, editor_.spelling());
    editor_.replace(word.span, text);
  }
  if (first_axis == nullptr) {
    // G1 F500 alone moves nowhere, but to where the correction is.
    if (!both.empty()) editor_.insert_after(block.words.back().span.end, both);
    return;
  }
  if (!codes_before.empty()) editor_.insert_before(first_axis->span.begin, codes_before);
  if (!words.empty()) editor_.insert_after(last_axis->span.end, words);
}

void PieceWriter::change_feed_word(const Step& step, const Piece& piece) {
  if (!piece.feed) return;
  const Word* word = find_word(*step.block, 'F');
  if (word != nullptr && word->value == *piece.feed) return;
  Spelling plain = editor_.spelling();
  plain.spaced = false;
  if (word != nullptr) return append_word(editor_.replace(word->span), 'F', *piece.feed, kMostDecimals, plain);
  std::string text;
  append_word(text, 'F', *piece.feed, kMostDecimals, plain);
  const Block& block = *step.block;
  std::uint32_t at = 0;
  for (const Word& other : block.words) at = std::max(at, other.span.end);
  editor_.insert_after(at, text);
}

}  // namespace plumbline::nc
