#include "nc/plain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/characters.hpp"
#include "base/check.hpp"
#include "base/number_text.hpp"
#include "base/units.hpp"
#include "nc/kept.hpp"
#include "nc/line_head.hpp"

namespace plumbline::nc {
namespace {

constexpr double kStands = 1e-9;  // mm and deg under which an axis does not move

bool is_polar(const Word& word) { return word.letter == '@' || word.letter == '^'; }

// Active comments that show parameters, which a program without parameters has not.
bool shows_parameters(std::string_view comment) {
  std::string text;
  for (const char c : comment.substr(1)) {
    if (c != ' ' && c != '\t') text += lower(c);
    if (text.size() > 6) break;
  }
  const bool active = text.starts_with("debug,") || text.starts_with("print,") || text.starts_with("log,");
  return active && comment.find('#') != std::string_view::npos;
}

double unit_of(const Step& step, Axis axis) { return step.after->inches && !is_rotary(axis) ? kMmPerInch : 1; }

bool is_plain(const Step& step, bool keeps_settings) {
  const Block& block = *step.block;
  if (!keeps_settings && !block.settings.empty()) return false;
  if (!block.left_out.empty()) return false;
  if (step.polar && step.cycle == CycleForm::none && step.motions.size() == 1) return false;
  for (const Comment& comment : block.comments) {
    if (!keeps_settings && shows_parameters(block.at(comment.span))) return false;
  }
  const auto plain = [](const Argument& argument) { return argument.plain; };
  if (!keeps_settings && !std::all_of(block.arguments.begin(), block.arguments.end(), plain)) return false;
  return std::all_of(block.words.begin(), block.words.end(),
                     [](const Word& word) { return word.expression == kLiteral; });
}

}  // namespace

// NAME: of a program that is written out, where nothing jumps there and the same name would stand more than once.
Span PlainSteps::label_of(const Block& block) const {
  if (dialect_.syntax.statements != Statements::high_level || block.kind != LineKind::block) return {};
  if (head_of(block.text, dialect_).label.empty()) return {};
  const std::size_t before = std::max(block.number.end, block.slash.end);
  const std::size_t begin = block.text.find_first_not_of(" \t", before);
  std::size_t end = block.text.find(':', begin) + 1;
  if (before == 0)
    end = std::min(block.text.find_first_not_of(" \t", end), block.text.size());  // else those before it go
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

const Step* PlainSteps::plain(const Step& step, bool keeps_settings) {
  used_ = 0;
  const Block& block = *step.block;
  if (step.alarms) return &step;
  const Span label = keeps_settings ? Span{} : label_of(block);
  const bool has_label = label.end > label.begin;
  if (step.skipped || (is_plain(step, keeps_settings) && !has_label)) return &step;
  const bool vanishes = (!block.settings.empty() || has_label) && block.comments.empty();
  if (!keeps_settings && block.words.empty() && vanishes) return nullptr;
  spelling_ = spelling_of(block, spelling_);
  editor_.start(block, spelling_);
  if (has_label) editor_.replace(label, "");
  write_values(step, keeps_settings);
  if (!keeps_settings) {
    for (const Setting& setting : block.settings) editor_.replace(setting.whole, "");
    defuse_comments(block);
  }
  Own& own = next_own(step);
  editor_.apply(own.text);
  if (!is_blank(block.text.front())) own.text.erase(0, own.text.find_first_not_of(" \t"));
  own.step = step;
  if (step.cycle == CycleForm::none) own.step.polar = false;
  parse(own, step);
  // As many decimals as the control needs are written where the block changes, not as many as the value has.
  auto word = own.block.words.begin();
  bool polar_seen = false;
  const bool polar = step.cycle == CycleForm::none;
  for (const Word& before : block.words) {
    const bool end = polar && is_polar(before);
    if (end && polar_seen) continue;
    polar_seen = polar_seen || end;
    for (int i = end ? 2 : 1; i > 0; --i, ++word) {
      PLUMBLINE_CHECK(word != own.block.words.end());
      if (!end) word->value = before.value;  // where the text does not say it: increments, X=IC(5)
      if (before.expression != kLiteral || end) word->decimals = 0;
    }
  }
  return &own.step;
}

// A word with its value in place of an expression, as the language spells it: X5, CR=5, X=IC(5).
std::string PlainSteps::with_value(std::string_view text, const Word& word) const {
  const Spelling spelling{spelling_.lower_case, false, spelling_.point, spelling_.most_digits};
  std::string value;
  const bool whole = dialect_.habits.whole_words.find(word.letter) != std::string::npos;
  const bool has_parts = word.letter == 'G' && std::abs(word.value - std::round(word.value)) > kStands;  // G54.1
  if (whole && !has_parts) {
    append_word(value, word.letter, std::round(word.value), 0, {spelling_.lower_case, false, false, 0});
  } else {
    append_word(value, word.letter, word.value, kMostDecimals, spelling);
  }
  const std::size_t equals = text.find('=');
  if (word.letter == kNamedCode) return std::string(text);
  if (equals == std::string_view::npos) return value;
  if (word.mode != WordMode::modal) return std::string(text.substr(0, text.find('(') + 1)) + value.substr(1) + ')';
  const std::size_t name_end = text.find_last_not_of(" \t", equals - 1);
  return name_end == 0 ? value : std::string(text.substr(0, equals + 1)) + value.substr(1);
}

void PlainSteps::write_values(const Step& step, bool keeps_settings) {
  bool end_written = false;
  for (const Span& span : step.block->left_out) editor_.replace(span, "");
  for (const Argument& argument : step.block->arguments) {
    if (argument.plain || keeps_settings) continue;
    std::string text;
    append_decimal(text, argument.value, kMostDecimals);
    editor_.replace(argument.span, text);
  }
  for (const Word& word : step.block->words) {
    if (is_polar(word) && step.cycle == CycleForm::none) {
      write_polar_end(step, end_written, word.span);
    } else if (word.expression != kLiteral && !word.unknown) {
      editor_.replace(word.span, with_value(step.block->at(word.span), word));
    } else if (word.unknown && !keeps_settings) {
      refuse_at(*step.block, word.span, "emit-value-unknown",
                "this value is known only when the machine runs, and the program must be written without parameters",
                "write the value as a number, or the program without loops and subprograms");
    }
  }
}

void PlainSteps::write_polar_end(const Step& step, bool& written, Span span) {
  std::string text;
  if (!written) {
    const Motion& motion = step.motions.front();
    for (const Axis axis : {Axis::X, Axis::Y}) {
      const double value = motion.to[axis] - (step.after->incremental ? motion.from[axis] : 0);
      if (spelling_.spaced && !text.empty()) text += ' ';
      append_word(text, letter(axis), value / unit_of(step, axis), kMostDecimals,
                  {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    }
  }
  editor_.replace(span, text);
  written = true;
}

void PlainSteps::defuse_comments(const Block& block) {
  for (const Comment& comment : block.comments) {
    const std::string_view text = block.at(comment.span);
    if (!shows_parameters(text)) continue;
    editor_.replace({comment.span.begin, comment.span.begin + 1}, std::string(text.substr(0, 1)) + "was ");
  }
}

PlainSteps::Own& PlainSteps::next_own(const Step& like) {
  if (used_ == own_.size()) own_.emplace_back();
  Own& own = own_[used_++];
  own.text.clear();
  own.before = *like.after;
  own.after = *like.after;
  own.step = Step{};
  own.step.frame = like.frame;
  own.step.position = like.position;
  own.step.known = like.known;
  own.step.jumped = like.jumped;
  return own;
}

void PlainSteps::parse(Own& own, const Step& like) {
  own.block.file = like.block->file;
  own.block.text = own.text;
  own.block.line = like.block->line;
  own.block.line_end = like.block->line_end;
  own.block.offset = std::max<std::uint64_t>(like.block->offset, 1);  // the text is not at the begin of a file
  parser_.parse(own.block);
  own.block.offset = like.block->offset;
  own.step.block = &own.block;
}

void PlainSteps::add(Own& own) {
  own.step.before = &own.before;
  own.step.after = &own.after;
  list_.push_back(&own.step);
  made_.push_back(&own);
}

std::span<const Step* const> PlainSteps::moves(const Step& step) {
  used_ = std::max<std::size_t>(used_, 1);  // the first may be what plain() gave
  if (own_.empty()) own_.emplace_back();
  list_.clear();
  made_.clear();
  number_.clear();
  mode_ = step.before->motion;
  spelling_ = spelling_of(*step.block, spelling_);
  if (step.cycle == CycleForm::spindle && dialect_.habits.fanuc_cycles && is_one_hole(step)) {
    add_hole_in_place(step);
    return list_;
  }
  add_rest(step);
  if (step.cycle == CycleForm::spindle) {
    for (const Hole& hole : step.holes) step.call != nullptr ? add_called_hole(step, hole) : add_hole(step, hole);
  } else {
    const std::size_t waits = dwells_first(step) ? 1 : 0;  // which the rest of the block does
    for (const Motion& motion : step.motions.subspan(waits)) add_move(step, motion);
  }
  add_words_behind(step);
  if (list_.empty()) return list_;
  // Every line but the last needs an end, which the last of a file may lack.
  for (Own* const own : made_) {
    own->block.line_end = step.block->line_end.empty() && own != made_.back() ? "\n" : step.block->line_end;
  }
  return list_;
}

// The block without the words of its cycle, and without those that wait for the motion.
void PlainSteps::add_rest(const Step& step) {
  const bool timed = step.after->feed_mode == FeedMode::inverse_time;
  const std::string_view of_motion = timed ? "XYZABCRLPQIJK@^F" : "XYZABCRLPQIJK@^";
  const Block& block = *step.block;
  const BlockCodes codes = codes_.codes_of(block);
  editor_.start(block, spelling_);
  std::size_t left = 0;
  for (const Word& word : block.words) {
    const auto behind = codes.after_motion();
    const bool waits = std::any_of(behind.begin(), behind.end(), [&](const Word* other) { return other == &word; });
    const bool of_cycle = of_motion.find(word.letter) != std::string_view::npos
                              ? !codes_.other_code_takes(block, word.letter)
                              : codes_.is_motion(word) || codes_.is_call(word);
    if (waits || of_cycle) {
      editor_.replace(word.span, "");
    } else {
      ++left;
    }
  }
  if (step.executed_delete) editor_.replace(block.slash, "");
  if (left + block.comments.size() + block.settings.size() == 0) {
    number_ = block.at(block.number);
    return;
  }
  Own& own = next_own(step);
  editor_.apply(own.text);
  own.text.erase(0, std::min(own.text.find_first_not_of(" \t"), own.text.size()));
  own.before = *step.before;
  own.after.motion = step.before->motion;
  own.step.changes_tool = step.changes_tool;
  if (dwells_first(step)) {
    own.motion = step.motions.front();
    own.step.motions = {&own.motion, 1};
  }
  parse(own, step);
  add(own);
}

void PlainSteps::add_words_behind(const Step& step) {
  const BlockCodes codes = codes_.codes_of(*step.block);
  if (codes.after_motion().empty()) return;
  Own& own = next_own(step);
  for (const Word* word : codes.after_motion()) append_code(own.text, step.block->at(word->span), spelling_);
  own.before.motion = own.after.motion = mode_;
  own.step.loses_position = step.loses_position;
  parse(own, step);
  add(own);
}

// P counts whole milliseconds on some controls, which take no point in it.
void PlainSteps::append_dwell(std::string& text, double seconds) const {
  const char letter = codes_.dwell_letter();
  const double per_count = letter == 'P' ? dialect_.habits.dwell_p_s : 1;
  const bool whole = per_count != 1;
  append_word(text, letter, seconds / per_count, whole ? 0 : kMostDecimals,
              {spelling_.lower_case, spelling_.spaced, spelling_.point && !whole, spelling_.most_digits});
}

// Of R and Q as of Z.
void PlainSteps::append_axis(std::string& text, const Step& step, char letter, double mm) const {
  append_word(text, letter, kept(step, Axis::Z, mm / (step.after->inches ? kMmPerInch : 1)), kMostDecimals, spelling_);
}

// A word of the program's unit as the control keeps it.
double PlainSteps::kept(const Step& step, Axis axis, double value) const {
  return kept_value(value, kept_of(dialect_.habits, is_rotary(axis), step.after->inches, increment_ratio_), false);
}

void PlainSteps::add_move(const Step& step, const Motion& motion) {
  AxisSet moved;
  for (const Axis axis : kAllAxes) {
    if (std::abs(motion.to[axis] - motion.from[axis]) > kStands || !motion.known_before.contains(axis)) {
      if (motion.known_after.contains(axis)) moved.insert(axis);
    }
  }
  const bool dwells = motion.kind == MotionKind::dwell;
  if (moved.empty() && !dwells) return;
  Own& own = next_own(step);
  own.text = std::exchange(number_, {});
  own.before.motion = mode_;
  if (dwells) {
    append_code(own.text, codes_.dwell(), spelling_);
    append_dwell(own.text, motion.dwell_s);
  } else {
    mode_ = motion.kind == MotionKind::rapid ? MotionMode::rapid : MotionMode::feed;
    append_code(own.text, codes_.motion(mode_), spelling_);
    for (const Axis axis : kAllAxes) {
      if (!moved.contains(axis)) continue;
      const double value = motion.to[axis] - (step.after->incremental ? motion.from[axis] : 0);
      append_word(own.text, letter(axis), kept(step, axis, value / unit_of(step, axis)), kMostDecimals, spelling_);
    }
    const bool needs_feed = motion.kind == MotionKind::feed && motion.feed_mode == FeedMode::inverse_time;
    if (needs_feed) append_word(own.text, 'F', motion.feed, kMostDecimals, spelling_);
  }
  own.after.motion = mode_;
  own.motion = motion;
  own.step.motions = {&own.motion, 1};
  own.step.named = dwells ? AxisSet{} : moved;
  parse(own, step);
  for (Word& word : own.block.words) word.decimals = 0;
  add(own);
}

// The way to above the hole, then a cycle of its own with every word stated, absolute.
void PlainSteps::add_hole(const Step& step, const Hole& hole) {
  const std::size_t waits = dwells_first(step) ? 1 : 0;  // which the rest of the block does
  for (std::size_t i = std::max(hole.approach_begin, waits); i < hole.approach_end; ++i) {
    add_move(step, step.motions[i]);
  }
  const PlaneAxes axes = axes_of(step.after->plane);
  const Motion& above = step.motions[hole.approach_end - 1];
  if (!step.after->retract_to_r && above.to[axes.third] < hole.clear) {
    Motion up = above;
    up.from = above.to;
    up.to[axes.third] = hole.clear;
    up.known_before = above.known_after;
    add_move(step, up);
  }
  Own& own = next_own(step);
  own.text = std::exchange(number_, {});
  if (step.after->incremental) append_code(own.text, codes_.distance(false), spelling_);
  append_code(own.text, codes_.cycle(hole.code), spelling_);
  append_axis(own.text, step, letter(axes.first), hole.first);
  append_axis(own.text, step, letter(axes.second), hole.second);
  append_axis(own.text, step, letter(axes.third), hole.bottom);
  append_axis(own.text, step, 'R', hole.r);
  if (hole.dwell_s && dialect_.habits.return_levels) {
    append_word(own.text, 'P', *hole.dwell_s, kMostDecimals, spelling_);  // as it was: what it counts is a setting
  } else if (hole.dwell_s) {
    append_dwell(own.text, *hole.dwell_s);
  }
  if (hole.ijk) {
    for (std::size_t i = 0; i < 3; ++i) append_axis(own.text, step, "IJK"[i], (*hole.ijk)[i]);
  }
  own.before.motion = mode_;
  own.hole = hole;
  own.hole.begin = 0;
  own.step.motions = step.motions.subspan(hole.begin, hole.end - hole.begin);
  own.step.holes = {&own.hole, 1};
  own.step.role = BlockRole::cycle;
  own.step.cycle = CycleForm::spindle;
  own.step.loses_position = step.loses_position;
  own.step.named = AxisSet::linear();
  own.after.incremental = false;
  own.after.motion = mode_ = MotionMode::cycle;
  parse(own, step);
  for (Word& word : own.block.words) word.decimals = 0;
  add(own);
  if (!step.after->incremental) return;
  Own& back = next_own(step);
  append_code(back.text, codes_.distance(true), spelling_);
  back.before.incremental = false;
  back.before.motion = back.after.motion = mode_;
  parse(back, step);
  add(back);
}

// The block itself, its hole stated as position: a rigid tap ends at any other motion, and a move between M29 and G84
// is an alarm [B-62764EN 13.2], so that nothing may stand between its blocks.
void PlainSteps::add_hole_in_place(const Step& step) {
  const Block& block = *step.block;
  const Hole& hole = step.holes.front();
  const PlaneAxes axes = axes_of(step.after->plane);
  editor_.start(block, spelling_);
  if (step.executed_delete) editor_.replace(block.slash, "");
  std::string missing;
  const auto state = [&](char letter, double mm) {
    std::string text;
    const Word* const word = find_word(block, letter);
    if (word == nullptr && spelling_.spaced && !missing.empty()) text += ' ';
    append_word(text, letter, kept(step, Axis::Z, mm / (step.after->inches ? kMmPerInch : 1)), kMostDecimals,
                {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    if (word != nullptr) return editor_.replace(word->span, text);
    missing += text;
  };
  state(letter(axes.first), hole.first);
  state(letter(axes.second), hole.second);
  state(letter(axes.third), hole.bottom);
  state('R', hole.r);
  if (!missing.empty()) editor_.insert_after(block.words.back().span.end, missing);
  Own& own = next_own(step);
  editor_.apply(own.text);
  own.before = *step.before;
  own.hole = hole;
  own.step.motions = step.motions;
  own.step.holes = {&own.hole, 1};
  own.step.role = BlockRole::cycle;
  own.step.cycle = CycleForm::spindle;
  own.step.loses_position = step.loses_position;
  own.step.changes_tool = step.changes_tool;
  own.step.named = AxisSet::linear();
  own.after.motion = mode_ = MotionMode::cycle;
  parse(own, step);
  for (Word& word : own.block.words) word.decimals = 0;
  add(own);
  own.block.line_end = block.line_end;
}

bool PlainSteps::is_one_hole(const Step& step) {
  const bool counts = find_word(*step.block, 'K') != nullptr || find_word(*step.block, 'L') != nullptr;
  return step.holes.size() == 1 && !counts && !dwells_first(step) && !step.after->incremental;
}

const Step* PlainSteps::without_call(const Step& step) {
  const Block& block = *step.block;
  used_ = 0;
  spelling_ = spelling_of(block, spelling_);
  editor_.start(block, spelling_);
  write_values(step, false);
  for (const Word& word : block.words) {
    const CodeRow* const row = dialect_.row_of(word);
    const bool calls = row != nullptr && (row->action == Action::call_program || row->action == Action::end_program);
    const bool of_call = (word.letter == 'P' || word.letter == 'L') && word.expression == kLiteral;
    if (calls || of_call) editor_.replace(word.span, "");
  }
  Own& own = next_own(step);
  editor_.apply(own.text);
  own.step = step;
  own.step.flow = false;
  own.step.entry = {};
  parse(own, step);
  return &own.step;
}

}  // namespace plumbline::nc
