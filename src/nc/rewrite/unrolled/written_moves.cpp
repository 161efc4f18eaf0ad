#include "nc/rewrite/unrolled/written_moves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/rewrite/output/emit_text.hpp"

namespace plumbline::nc {
namespace {

constexpr double kStands = 1e-9;  // mm and deg under which an axis does not move

// Of the block of one hole; its motions are those of `step` from `begin` on.
void make_hole(MadeStep& own, const Step& step, const Hole& hole, std::size_t begin) {
  own.hole = hole;
  own.step.motions = step.motions.subspan(begin, hole.end - begin);
  own.step.holes = {&own.hole, 1};
  own.step.role = BlockRole::cycle;
  own.step.cycle = CycleForm::spindle;
  own.step.call = step.call;
  own.step.loses_position = step.loses_position;
  own.step.named = AxisSet::linear();
}

// What G4 counts under G95 and G93 is not known on some controls, whatever P of the cycle counts.
void refuse_unknown_dwell(const Step& step, const Dialect& dialect) {
  const FeedMode mode = step.after->feed_mode;
  const bool unknown = (mode == FeedMode::per_revolution && dialect.behaviour.dwell_unknown_per_revolution) ||
                       (mode == FeedMode::inverse_time && dialect.behaviour.dwell_unknown_inverse_time);
  if (!unknown) return;
  refuse_at(*step.block, {0, static_cast<std::uint32_t>(step.block->text.size())}, codes::kNotInterpreted,
            "the cycle waits, it must be written out, and whether G4 counts seconds in this feed mode depends on the "
            "control",
            "write G94 before the cycle, with a feed per minute");
}

// Under G91 the levels of a cycle that is called by its name are positions, and so is X=AC(5) of the move before it.
bool is_position(const Step& step, const Motion& motion, Axis axis) {
  if (!step.after->incremental || step.call == nullptr) return false;
  if (&motion != step.motions.data()) return true;
  const Word* const word = find_word(*step.block, letter(axis));
  return word == nullptr || word->mode == WordMode::absolute;
}

// A Fanuc executes them over the first hole, before it is drilled [B-63324EN 13.1], an OSP as the axes have arrived
// [T P-481].
void refuse_words_of_cycle(const Step& step, const BlockCodes& codes, const Dialect& dialect) {
  for (const Word* const word : codes.after_motion()) {
    const CodeRow* const row = dialect.row_of(*word);
    const bool calls = row != nullptr && (row->action == Action::call_program || row->action == Action::end_program);
    if (calls) continue;
    refuse_at(
        *step.block, word->span, "emit-m-code",
        fmt::format("{} beside a drilling cycle acts {} the hole is drilled, and the cycle is written out in "
                    "several blocks",
                    step.block->at(word->span), dialect.syntax.statements == Statements::user_task ? "when" : "before"),
        "put it into a block of its own, before the cycle or after it");
  }
}

// P counts whole milliseconds on some controls, which take no point in it.
void append_dwell(std::string& text, double seconds, char letter, const Dialect& dialect, const Spelling& spelling) {
  const double per_count = letter == 'P' ? dialect.behaviour.dwell_p_s : 1;
  const bool whole = per_count != 1;
  append_word(text, letter, seconds / per_count, whole ? 0 : kMostDecimals,
              {spelling.lower_case, spelling.spaced, spelling.point && !whole, spelling.most_digits});
}

}  // namespace

void WrittenMoves::add(MadeStep& own) {
  own.step.before = &own.before;
  own.step.after = &own.after;
  list_.push_back(&own.step);
  owned_.push_back(&own);
}

std::span<const Step* const> WrittenMoves::of(const Step& step, bool anew) {
  made_.clear();
  list_.clear();
  owned_.clear();
  number_.clear();
  mode_ = step.before->motion;
  spelling_ = spelling_of(*step.block, spelling_);
  if (step.cycle == CycleForm::spindle && dialect_.behaviour.fanuc_cycles && is_one_hole(step)) {
    add_hole_in_place(step, anew);
    return list_;
  }
  add_rest(step);
  if (step.cycle == CycleForm::spindle) {
    for (const Hole& hole : step.holes) step.call != nullptr ? add_called_hole(step, hole) : add_hole(step, hole);
  } else {
    const std::size_t waits = dwells_first(step) ? 1 : 0;  // which the rest of the block does
    add_moves(step, step.motions.subspan(waits));
  }
  add_words_after(step);
  if (list_.empty()) return list_;
  // Every line but the last needs an end, which the last of a file may lack.
  for (MadeStep* const own : owned_) {
    own->block.line_end = step.block->line_end.empty() && own != owned_.back() ? "\n" : step.block->line_end;
  }
  return list_;
}

// The block without the words of its cycle, and without those that wait for the motion.
void WrittenMoves::add_rest(const Step& step) {
  const bool timed = step.after->feed_mode == FeedMode::inverse_time;
  const std::string_view of_motion = timed ? "XYZABCRLPQIJK@^1F" : "XYZABCRLPQIJK@^1";
  const Block& block = *step.block;
  const BlockCodes codes = codes_.codes_of(block);
  editor_.start(block, spelling_);
  std::size_t words_left = 0;
  for (const Word& word : block.words) {
    const auto after_motion = codes.after_motion();
    const bool waits =
        std::any_of(after_motion.begin(), after_motion.end(), [&](const Word* other) { return other == &word; });
    const bool of_cycle = of_motion.find(word.letter) != std::string_view::npos
                              ? !codes_.other_code_takes(block, word.letter)
                              : codes_.is_motion(word) || codes_.is_call(word);
    if (waits || of_cycle) {
      editor_.replace(word.span, "");
    } else {
      ++words_left;
    }
  }
  drop_slash(editor_, step);
  if (words_left + block.comments.size() + block.settings.size() == 0) {
    number_ = block.at(block.number);
    return;
  }
  MadeStep& own = made_.next(step);
  editor_.apply(own.text);
  own.text.erase(0, std::min(own.text.find_first_not_of(" \t"), own.text.size()));
  own.before = *step.before;
  own.after.motion = step.before->motion;
  own.step.tool_change = step.tool_change;
  if (dwells_first(step)) {
    own.motion = step.motions.front();
    own.step.motions = {&own.motion, 1};
  }
  made_.parse(own, step);
  add(own);
}

void WrittenMoves::add_words_after(const Step& step) {
  const BlockCodes codes = codes_.codes_of(*step.block);
  if (codes.after_motion().empty()) return;
  if (step.cycle != CycleForm::none && dialect_.behaviour.fanuc_cycles) refuse_words_of_cycle(step, codes, dialect_);
  MadeStep& own = made_.next(step);
  for (const Word* word : codes.after_motion()) append_code(own.text, step.block->at(word->span), spelling_);
  own.before.motion = own.after.motion = mode_;
  own.step.loses_position = step.loses_position;
  made_.parse(own, step);
  add(own);
}

// Of R and Q as of Z.
void WrittenMoves::append_axis(std::string& text, const Step& step, char letter, double mm) const {
  append_word(text, letter, kept(step, Axis::Z, mm / step.after->unit_of(Axis::Z)), kMostDecimals, spelling_);
}

// A word of the program's unit as the control keeps it.
double WrittenMoves::kept(const Step& step, Axis axis, double value) const {
  const Kept kept = kept_of_axis_word(dialect_.behaviour, is_rotary(axis), step.after->inches, increment_ratio_, false);
  return kept_value(value, kept, false);
}

// Where a control drills in exact path mode, whatever mode is in force, a wait of no time ends each move as exactly: it
// needs not know which tolerance comes back behind the hole.
void WrittenMoves::add_moves(const Step& step, std::span<const Motion> motions) {
  const bool drills = step.cycle != CycleForm::none && !step.holes.empty();
  const bool stops =
      drills && dialect_.behaviour.cycles_exact_path && step.after->path_control == PathControl::continuous;
  for (const Motion& motion : motions) {
    const std::size_t before = list_.size();
    add_move(step, motion);
    const bool waits =
        motion.kind == MotionKind::dwell || (&motion != &motions.back() && (&motion)[1].kind == MotionKind::dwell);
    if (!stops || waits || list_.size() == before) continue;
    Motion stop = motion;
    stop.kind = MotionKind::dwell;
    stop.from = motion.to;
    stop.known_before = motion.known_after;
    stop.dwell_s = 0;
    add_move(step, stop);
  }
}

void WrittenMoves::add_move(const Step& step, const Motion& motion) {
  AxisSet moved;
  for (const Axis axis : kAllAxes) {
    if (std::abs(motion.to[axis] - motion.from[axis]) > kStands || !motion.known_before.contains(axis)) {
      if (motion.known_after.contains(axis)) moved.insert(axis);
    }
  }
  const bool dwells = motion.kind == MotionKind::dwell;
  const bool first = &motion == &step.motions[dwells_first(step) ? 1 : 0];
  if (first && !dwells) moved = moved | step.new_place;
  const bool no_hole = step.cycle != CycleForm::none && step.holes.empty();  // NCYL: the cycle before ends with it
  if (moved.empty() && no_hole) moved.insert(axes_of(step.after->plane).third);
  if (moved.empty() && !dwells) return;
  MadeStep& own = made_.next(step);
  own.text = std::exchange(number_, {});
  own.before.motion = mode_;
  if (dwells) {
    refuse_unknown_dwell(step, dialect_);
    append_code(own.text, codes_.dwell(), spelling_);
    if (motion.dwell_turns > 0) {
      append_word(own.text, 'S', motion.dwell_turns, kMostDecimals, spelling_);
    } else {
      append_dwell(own.text, motion.dwell_s, codes_.dwell_letter(), dialect_, spelling_);
    }
  } else {
    mode_ = motion.kind == MotionKind::rapid ? MotionMode::rapid : MotionMode::feed;
    append_code(own.text, codes_.motion(mode_), spelling_);
    for (const Axis axis : kAllAxes) {
      if (!moved.contains(axis)) continue;
      const bool position = is_position(step, motion, axis);
      const double value = motion.to[axis] - (step.after->incremental && !position ? motion.from[axis] : 0);
      const std::size_t begin = own.text.size();
      append_word(own.text, letter(axis), kept(step, axis, value / step.after->unit_of(axis)), kMostDecimals,
                  spelling_);
      if (position) own.text.insert(own.text.find_first_not_of(' ', begin) + 1, "=AC(") += ')';
    }
    const bool needs_feed = motion.kind == MotionKind::feed && motion.feed_mode == FeedMode::inverse_time;
    if (needs_feed) append_word(own.text, 'F', motion.feed, kMostDecimals, spelling_);
  }
  own.after.motion = mode_;
  own.motion = motion;
  own.step.motions = {&own.motion, 1};
  own.step.named = dwells ? AxisSet{} : moved;
  made_.parse(own, step);
  for (Word& word : own.block.words) word.decimals = 0;
  add(own);
}

// The way to above the hole, then a cycle of its own with every word stated, absolute.
void WrittenMoves::add_hole(const Step& step, const Hole& hole) {
  const std::size_t waits = dwells_first(step) ? 1 : 0;  // which the rest of the block does
  const std::size_t approach = std::max(hole.approach_begin, waits);
  if (approach < hole.approach_end) add_moves(step, step.motions.subspan(approach, hole.approach_end - approach));
  const PlaneAxes axes = axes_of(step.after->plane);
  const Motion& above = step.motions[hole.approach_end - 1];
  // A cycle that begins goes back to where the tool stands; one that goes on, to where the first of them began.
  if (!step.after->retract_to_r && above.to[axes.third] != hole.clear) {
    Motion to_level = above;
    to_level.from = above.to;
    to_level.to[axes.third] = hole.clear;
    to_level.machine = step.frame->to_machine(to_level.to);
    to_level.known_before = above.known_after;
    add_move(step, to_level);
  }
  MadeStep& own = made_.next(step);
  own.text = std::exchange(number_, {});
  if (step.after->incremental) append_code(own.text, codes_.distance(false), spelling_);
  append_code(own.text, codes_.cycle(hole.code), spelling_);
  append_axis(own.text, step, letter(axes.first), hole.first);
  append_axis(own.text, step, letter(axes.second), hole.second);
  append_axis(own.text, step, letter(axes.third), hole.bottom);
  append_axis(own.text, step, 'R', hole.r);
  if (hole.dwell_s) append_dwell(own.text, *hole.dwell_s, codes_.dwell_letter(), dialect_, spelling_);
  if (hole.ijk) {
    for (std::size_t i = 0; i < 3; ++i) append_axis(own.text, step, "IJK"[i], (*hole.ijk)[i]);
  }
  own.before.motion = mode_;
  make_hole(own, step, hole, hole.begin);
  own.after.incremental = false;
  own.after.motion = mode_ = MotionMode::cycle;
  made_.parse(own, step);
  for (Word& word : own.block.words) word.decimals = 0;
  add(own);
  if (!step.after->incremental) return;
  MadeStep& back = made_.next(step);
  append_code(back.text, codes_.distance(true), spelling_);
  back.before.incremental = false;
  back.before.motion = back.after.motion = mode_;
  made_.parse(back, step);
  add(back);
}

// P, Q, I, J and FA, which stand in a block before.
void WrittenMoves::append_taken_over(std::string& text, const Step& step) const {
  const Hole& hole = step.holes.front();
  const bool by_depth = hole.peck_to_r > 0;
  const auto append = [&](char letter, double value) {
    if (value == 0 || find_word(*step.block, letter) != nullptr) return;
    if (spelling_.spaced && !text.empty()) text += ' ';
    const bool feeds_out = letter == kFeedOutLetter;
    const bool point = letter == 'P' ? hole.dwell_pointed : spelling_.point;
    const std::size_t begin = text.size();
    append_word(text, feeds_out ? 'F' : letter, value, kMostDecimals,
                {spelling_.lower_case, false, point, spelling_.most_digits});
    if (feeds_out) text.insert(begin + 1, "A=");
  };
  const auto length = [&](double mm) { return kept(step, Axis::Z, mm / step.after->unit_of(Axis::Z)); };
  append('P', hole.dwell_s.value_or(0) / (hole.dwell_pointed ? 1 : dialect_.behaviour.dwell_p_s));
  append('Q', by_depth ? 0 : length(hole.peck));
  append('I', by_depth ? length(hole.peck) : 0);
  append('J', length(hole.peck_to_r));
  append(kFeedOutLetter, hole.feed_out);
}

// The block itself, its hole stated as position: a rigid tap ends at any other motion, and a move between M29 and G84
// is an alarm [B-62764EN 13.2], so that nothing may stand between its blocks.
void WrittenMoves::add_hole_in_place(const Step& step, bool anew) {
  const Block& block = *step.block;
  const Hole& hole = step.holes.front();
  const PlaneAxes axes = axes_of(step.after->plane);
  editor_.start(block, spelling_);
  drop_slash(editor_, step);
  const Word* const head = std::find_if(
      block.words.data(), block.words.data() + block.words.size(),
      [&](const Word& word) { return word.letter == letter(axes.first) || word.letter == letter(axes.second); });
  std::string missing;
  const auto state = [&](char letter, double mm) {
    std::string text;
    const Word* const word = find_word(block, letter);
    if (word == nullptr && spelling_.spaced && !missing.empty()) text += ' ';
    if (anew && word == head) {
      text = in_spelling(fmt::format("G{}", hole.row->code / 10), spelling_) + (spelling_.spaced ? " " : "");
    }
    append_word(text, letter, kept(step, Axis::Z, mm / step.after->unit_of(Axis::Z)), kMostDecimals,
                {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    if (word != nullptr) return editor_.replace(word->span, text);
    missing += text;
  };
  state(letter(axes.first), hole.first);
  state(letter(axes.second), hole.second);
  state(letter(axes.third), hole.bottom);
  state('R', hole.r);
  if (anew) append_taken_over(missing, step);
  if (!missing.empty()) editor_.insert_after(block.words.back().span.end, missing);
  MadeStep& own = made_.next(step);
  editor_.apply(own.text);
  own.before = *step.before;
  make_hole(own, step, hole, 0);
  own.step.tool_change = step.tool_change;
  own.after.motion = mode_ = MotionMode::cycle;
  made_.parse(own, step);
  for (Word& word : own.block.words) word.decimals = 0;
  add(own);
  own.block.line_end = block.line_end;
}

// A hole that a called cycle makes (CYCLE84, MCALL CYCLE83): the way to above it, then a call for it alone.
void WrittenMoves::add_called_hole(const Step& step, const Hole& hole) {
  for (std::size_t i = hole.approach_begin; i < hole.approach_end; ++i) add_move(step, step.motions[i]);
  MadeStep& own = made_.next(step);
  own.text = std::exchange(number_, {});
  append_code(own.text, step.call->row->name, spelling_);
  own.text += '(';
  for (std::size_t i = 0; i < step.call->arguments.size(); ++i) {
    if (i > 0) own.text += ',';
    own.text += step.call->arguments[i].text;
  }
  own.text += ')';
  make_hole(own, step, hole, hole.begin);
  own.before.motion = own.after.motion = mode_;
  made_.parse(own, step);
  add(own);
}

bool WrittenMoves::is_one_hole(const Step& step) {
  const bool counts = find_word(*step.block, 'K') != nullptr || find_word(*step.block, 'L') != nullptr;
  return step.holes.size() == 1 && !counts && !dwells_first(step) && !step.after->incremental;
}

}  // namespace plumbline::nc
