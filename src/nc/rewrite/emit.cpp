#include "nc/rewrite/emit.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/refusal.hpp"
#include "nc/rewrite/feed.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSameOffset = 1e-9;  // mm, inches and deg
constexpr std::size_t kCopyChunk = std::size_t{1} << 16U;
constexpr std::string_view kSkipped = "block delete is on: this block was left out";

// Only the words that tell where the control stands: their values grow by what the control is off.
bool shifts_words(const Step& step, const AxisWords& shift) {
  return std::any_of(kAllAxes.begin(), kAllAxes.end(),
                     [&](Axis axis) { return step.named.contains(axis) && std::abs(shift[axis]) > 1e-9; });
}

// The file's byte order mark is the header's, which goes out before the stamp.
std::string_view without_mark(const Block& block, std::string_view text) {
  const std::string_view mark = block.text.substr(0, byte_order_mark_size(block));
  return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

// What is left of a block that held nothing but words of endless axes that stand.
bool is_blank_line(std::string_view line) { return line.find_first_not_of(" \t") == std::string_view::npos; }

// A feed of axes that turn, and of nothing else: its F counts degrees.
bool turns_alone(const Motion& motion) {
  if (motion.kind != MotionKind::feed || motion.feed_mode != FeedMode::per_minute) return false;
  const AxisWords delta = motion.to - motion.from;
  const double linear = std::hypot(delta[Axis::X], delta[Axis::Y], delta[Axis::Z]);
  return linear == 0 && delta != AxisWords{} && feed_length_is_angle(linear);
}

// What the control is off, in the words of a block that sets an offset: G10 L20 may name a system that is turned
// otherwise than the active one.
AxisWords offset_shift(const Step& step, const OutputState& control) {
  Frame turned;
  turned.rotation_deg = step.offset_rotation_deg;
  return control.work_shift(turned);
}

}  // namespace

Emitter::Emitter(const InputFile& source, const Dialect& dialect, EmitSettings settings, OutputFile& out, Form form)
    : source_(source),
      dialect_(dialect),
      settings_(std::move(settings)),
      out_(out),
      planner_(dialect_, settings_),
      codes_(dialect_),
      writer_(codes_),
      form_(form),
      changed_(form == Form::unrolled) {
  spelling_.point = dialect_.behaviour.always_point;
  spelling_.most_digits = dialect_.behaviour.most_digits;
}

std::string_view Emitter::line_end(const Step& step) const {
  if (unrolls()) return newline_;
  return step.block->line_end.empty() ? std::string_view(newline_) : step.block->line_end;
}

void Emitter::copy_source(std::uint64_t from, std::uint64_t to) {
  std::string chunk;
  while (from < to) {
    chunk.resize(std::min<std::uint64_t>(kCopyChunk, to - from));
    const std::size_t got = source_.read(from, chunk.data(), chunk.size());
    PLUMBLINE_CHECK(got > 0);
    out_.write(std::string_view(chunk).substr(0, got));
    from += got;
  }
}

// The stamp stands behind %, a program number and the comments that the program begins with.
void Emitter::note_header(const Step& step) {
  const Block& block = *step.block;
  spelling_ = spelling_of(block, spelling_);
  source_end_ = block.offset + block.text.size() + block.line_end.size();
  if (!block.line_end.empty() && (in_header_ || !unrolls())) newline_ = block.line_end;
  if (block.kind == LineKind::percent) ++percents_;
  tool_ = step.frame->tool;
  if (!in_header_) return;
  header_end_ = std::max<std::uint64_t>(header_end_, byte_order_mark_size(block));
  const bool text = block.words.empty() && block.settings.empty() && !block.block_delete;  // / is rewritten
  const bool blank = text && block.comments.empty() && block.kind == LineKind::block;
  const bool number = block.flow.word == FlowWord::program && !block.block_delete;
  if (block.kind == LineKind::percent || (text && !block.comments.empty()) || number) {
    header_end_ = source_end_;
  } else if (!blank) {
    in_header_ = false;
    if (unrolls()) write_stamp();
  }
}

void Emitter::write_stamp() {
  for (const std::string& line : settings_.stamp) {
    const std::size_t room = dialect_.line_length - std::min(dialect_.line_length, dialect_.comment_open.size() +
                                                                                       dialect_.comment_close.size());
    out_.write(dialect_.comment_open + line.substr(0, room) + dialect_.comment_close + newline_);
  }
  guard_span_.first = out_.size();
  for (const std::string& line : settings_.guard) out_.write(line + newline_);
  guard_span_.second = out_.size();
}

// Nothing was written as long as nothing had to change; now the text up to this block goes out, the stamp in it.
void Emitter::begin_change(const Step& step) {
  if (unrolls()) return write_entries();
  in_header_ = false;
  if (changed_) return;
  changed_ = true;
  if (only_looks_) return;
  copy_source(0, header_end_);
  write_stamp();
  if (undo_ != nullptr) undo_->replaced(header_end_, out_.size() - header_end_, {});
  std::uint64_t at = header_end_;
  for (const Replacement& r : before_change_) {
    copy_source(at, r.offset);
    if (undo_ != nullptr) undo_->replaced(out_.size(), r.text.size(), r.original);
    out_.write(r.text);
    at = r.offset + r.original.size();
  }
  copy_source(at, step.block->offset);
  before_change_.clear();
}

// What was written since `begin` stands for the block, unless it is the block.
void Emitter::note_replaced(const Step& step, std::uint64_t begin) {
  if (undo_ == nullptr || grouping_ || unrolls()) return;
  const Block& block = *step.block;
  const std::string_view original = without_mark(block, block.text);
  const std::uint64_t size = out_.size() - begin;
  if (size == original.size() + block.line_end.size() && line_ == block.text) return;
  undo_->replaced(begin, size, std::string(original) + std::string(block.line_end));
}

void Emitter::write_line(const Step& step, std::string_view text) {
  if (longest_line(text) > dialect_.line_length) {
    refuse_block(*step.block, "emit-line-too-long",
                 fmt::format("the corrected block has {} characters, and {} takes {}", text.size(), dialect_.name,
                             dialect_.line_length),
                 "put comments or other words of this block on a line of their own");
  }
  out_.write(without_mark(*step.block, text));
}

// F and its mode as the original has them, before a block that counts on them.
void Emitter::restore_feed_state(const Step& step, bool has_feed_word) {
  const bool cuts = std::any_of(step.motions.begin(), step.motions.end(), [](const Motion& m) {
    return m.kind == MotionKind::feed || m.kind == MotionKind::arc || m.kind == MotionKind::probe;
  });
  line_.clear();
  if (control_.feed_mode != step.before->feed_mode && (cuts || step.loses_position)) {
    line_ += codes_.feed_mode(step.before->feed_mode);
    control_.feed_mode = step.before->feed_mode;
    control_.drop_feed();
  }
  const bool turns = std::any_of(step.motions.begin(), step.motions.end(), turns_alone);
  const double feed = turns ? step.before->feed_rotary : step.before->feed;
  const bool needs_feed = (cuts && !has_feed_word) || step.loses_position;
  if (needs_feed && control_.feed_mode != FeedMode::inverse_time && feed > 0 &&
      (turns ? control_.feed_rotary : control_.feed) != feed) {
    append_word(line_, 'F', feed, kMostDecimals, {false, false, spelling_.point, spelling_.most_digits});
    control_.set_feed(feed);
  }
  if (line_.empty()) return;
  line_ += line_end(step);
  out_.write(line_);
}

void Emitter::copy(const Step& step) {
  note_header(step);
  const Block& block = *step.block;
  const BlockCodes codes = codes_.codes_of(block);
  if (step.role == BlockRole::stores_position) refuse_if_shifted(step);
  if (changed_) refuse_if_turned(step);
  if (step.cycle != CycleForm::none) note_cycle_level(step);
  if (step.skipped || step.executed_delete) {
    copy_with_choice_applied(step);
    return;
  }
  const bool offset_words = step.role == BlockRole::sets_offset && shifts_words(step, offset_shift(step, control_));
  const bool motion_missing = changed_ && !step.motions.empty() && codes.motion == nullptr &&
                              control_.motion != step.after->motion &&
                              (step.role == BlockRole::plain || (step.call != nullptr && !step.named.empty())) &&
                              step.motions.front().kind != MotionKind::dwell;
  if (offset_words || unrolls()) begin_change(step);
  if (changed_) {
    const std::uint64_t begin = out_.size();
    restore_feed_state(step, codes.feed != nullptr);
    editor_.start(block, spelling_);
    if (offset_words) add_offset_shifts(step);
    if (motion_missing) {
      const Word* first = first_axis_word(block);
      if (first == nullptr) first = &block.words.front();
      editor_.insert_before(first->span.begin, codes_.motion(step.after->motion));
      control_.motion = step.after->motion;
    }
    line_.clear();
    editor_.apply(line_);
    write_line(step, line_);
    out_.write(unrolls() ? newline_ : block.line_end);
    note_replaced(step, begin);
  }
  control_.follow(step, codes.motion != nullptr, codes.feed_mode != nullptr, codes.feed != nullptr);
}

void Emitter::refuse_if_shifted(const Step& step) const {
  for (const Axis axis : kAllAxes) {
    if (std::abs(control_.shift[axis]) <= 1e-9) continue;
    refuse_block(
        *step.block, "emit-stores-position",
        fmt::format("this block stores where the control stands, which is {:.4f} {} off in {} after the correction",
                    control_.shift[axis], is_rotary(axis) ? "deg" : "mm", letter(axis)),
        "store the position before the program runs, or move there in machine coordinates (G53) first");
  }
}

// Off by a little, an axis whose words count from where it stands may turn all the way round.
void Emitter::refuse_if_turned(const Step& step) const {
  if (step.motions.empty() || step.named.empty() || step.after->incremental) return;
  const AxisWords shift = control_.work_shift(*step.frame);
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    const bool endless = step.named.contains(axis) && step.after->rule_of(axis) != RotaryRule::linear;
    if (!endless || std::abs(shift[axis]) <= 1e-9) continue;
    refuse_block(*step.block, "emit-rotary-word",
                 fmt::format("{} stands {:.6g} deg off after the correction, and this block, which is not corrected, "
                             "counts its word from there",
                             letter(axis), shift[axis]),
                 "move it by increments (G91), or leave it out of the block");
  }
}

// G43.1 Z-8 G0 X1 moves to Z-8 and makes that the length of the tool: a correction of the one would change the other.
void Emitter::refuse_if_shared(const Step& step) const {
  const Word* const taker = codes_.codes_of(*step.block).axis_taker;
  if (taker == nullptr || step.named.empty()) return;
  refuse_at(*step.block, taker->span, "emit-shared-words",
            fmt::format("{} and the motion of this block both take its axis words", step.block->at(taker->span)),
            "put the two into blocks of their own");
}

// The words that a correction adds would stand beside a change of units, where nobody knows in which they count.
void Emitter::refuse_beside_unit(const Step& step) const {
  if (dialect_.behaviour.unknown_beside_unit.find('X') == std::string::npos ||
      step.before->inches == step.after->inches)
    return;
  refuse_block(*step.block, "emit-shared-words",
               "this block changes the unit and moves, and the move must be corrected",
               "put the change of units into a block of its own");
}

// With several pieces in its place the block's M code acts beside the first, or behind the last; its builder decides.
void Emitter::refuse_builders_codes(const Step& step) const {
  if (!dialect_.behaviour.m_beside_cut_unknown) return;
  for (const Word& word : step.block->words) {
    if (word.letter != 'M') continue;
    const CodeRow* const row = dialect_.row_of(word);
    const bool known = row != nullptr && row->action != Action::refused;
    if (known && !row->order_unknown) continue;
    refuse_at(
        *step.block, word.span, "emit-m-code",
        fmt::format("whether {} acts before the move of its block or behind it is the machine builder's choice, and "
                    "the corrected move has several blocks",
                    step.block->at(word.span)),
        "put it into a block of its own, before or behind the move");
  }
}

// The control works the offset out from where it stands; its words grow by what it is off, so that the offset is the
// one that the original gives.
void Emitter::add_offset_shifts(const Step& step) {
  const AxisWords shift = offset_shift(step, control_);
  for (const Word& word : step.block->words) {
    const std::optional<Axis> axis = axis_of(word.letter);
    if (!axis || std::abs(shift[*axis]) <= 1e-9) continue;
    const double exact = word.value + shift[*axis] / step.after->unit_of(*axis);
    const double kept = planner_.offset_word(step, *axis, exact);
    if (std::abs(kept - exact) > kSameOffset) {
      refuse_block(*step.block, "emit-stores-position",
                   fmt::format("{} sets an offset from where the control stands, which after the correction is no "
                               "multiple of what it keeps of a word",
                               letter(*axis)),
                   "write G20, G21 and G68 behind this block, or move there in machine coordinates (G53) first");
    }
    std::string text;
    append_word(text, word.letter, kept, kMostDecimals,
                {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    editor_.replace(word.span, text);
  }
}

// Block delete: what the control's switch would decide is decided in the text.
void Emitter::copy_with_choice_applied(const Step& step) {
  const Block& block = *step.block;
  std::string text;
  if (step.skipped) {
    text = dialect_.comment_open + std::string(kSkipped) + dialect_.comment_close;
  } else {
    editor_.start(block, spelling_);
    editor_.replace(block.slash, "");
    editor_.apply(text);
  }
  if (unrolls()) begin_change(step);
  if (!changed_) {
    if (!only_looks_) {
      before_change_.push_back({block.offset + byte_order_mark_size(block),
                                std::string(without_mark(block, block.text)), std::string(without_mark(block, text))});
    }
  } else {
    const std::uint64_t begin = out_.size();
    if (!step.skipped) restore_feed_state(step, find_word(block, 'F') != nullptr);
    write_line(step, text);
    out_.write(unrolls() ? newline_ : block.line_end);
    line_ = text;
    note_replaced(step, begin);
  }
  if (step.skipped) return;
  const BlockCodes codes = codes_.codes_of(block);
  control_.follow(step, codes.motion != nullptr, codes.feed_mode != nullptr, codes.feed != nullptr);
}

EmittedMove Emitter::move(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                          std::optional<double> seconds) {
  PLUMBLINE_CHECK(step.motions.size() == 1 && !points.empty());
  if (!changed_) control_.adopt(*step.before);
  if (planner_.stays(step, points, writable, control_)) {
    copy(step);
    return {false, 1, seconds, 0};
  }
  refuse_if_shared(step);
  refuse_beside_unit(step);
  note_header(step);
  begin_change(step);
  const std::uint64_t begin = out_.size();
  const std::span<Piece> pieces = planner_.plan(step, points, writable, seconds, control_);
  if (pieces.size() > 1) refuse_builders_codes(step);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool is_last = i + 1 == pieces.size();
    line_.clear();
    if (i == 0) {
      writer_.append_first(line_, step, pieces[i], spelling_, control_.motion, is_last);
      if (is_blank_line(line_)) line_ = dialect_.comment_open + std::string(kAllStand) + dialect_.comment_close;
    } else {
      writer_.append_further(line_, step, pieces[i], spelling_, is_last);
    }
    write_line(step, line_);
    out_.write(is_last && !unrolls() ? step.block->line_end : line_end(step));
  }
  note_replaced(step, begin);
  control_.motion = step.motions.front().kind == MotionKind::rapid ? MotionMode::rapid : MotionMode::feed;
  return {true, static_cast<int>(pieces.size()), planner_.seconds(), planner_.rounding_mm()};
}

void Emitter::begin_group(const Step& step) {
  note_header(step);
  begin_change(step);
  grouping_ = true;
  group_begin_ = out_.size();
  end_modal_call(step);
}

void Emitter::end_group(const Step& step) {
  grouping_ = false;
  line_.clear();
  note_replaced(step, group_begin_);
}

void Emitter::finish() {
  if (!changed_) copy_source(0, source_.size());
  if (unrolls() && percents_ == 1) out_.write("%" + newline_);
}

}  // namespace plumbline::nc
