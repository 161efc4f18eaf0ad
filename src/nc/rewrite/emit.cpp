#include "nc/rewrite/emit.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/comment_line.hpp"
#include "nc/language/refusal.hpp"
#include "nc/rewrite/emit_refusals.hpp"
#include "nc/rewrite/feed.hpp"
#include "nc/rewrite/unrolled/restored_modes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSameOffset = 1e-9;  // mm, inches and deg
constexpr std::string_view kSkipped = "block delete is on: this block was left out";

// Only the words that tell where the control stands: their values grow by what the control is off.
bool shifts_words(const Step& step, const AxisWords& shift) {
  return std::any_of(kAllAxes.begin(), kAllAxes.end(),
                     [&](Axis axis) { return step.named.contains(axis) && std::abs(shift[axis]) > 1e-9; });
}

// What is left of a block that held nothing but words of endless axes that stand.
bool is_blank_line(std::string_view line) { return line.find_first_not_of(" \t") == std::string_view::npos; }

// A feed of axes that turn, and of nothing else: its F counts degrees.
bool turns_alone(const Motion& motion) {
  if (motion.kind != MotionKind::feed || motion.feed_mode != FeedMode::per_minute) return false;
  const AxisWords delta = motion.to - motion.from;
  return delta != AxisWords{} && feed_length_is_angle(length_mm(delta));
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
    : dialect_(dialect),
      settings_(std::move(settings)),
      text_(source, dialect_, settings_, out, form == Form::unrolled),
      planner_(dialect_, settings_),
      codes_(dialect_),
      writer_(codes_),
      entries_(dialect_) {
  spelling_.point = dialect_.behaviour.always_point;
  spelling_.most_digits = dialect_.behaviour.most_digits;
}

void Emitter::follow(const Step& step) {
  text_.follow(step);
  spelling_ = spelling_of(*step.block, spelling_);
  tool_ = step.frame->tool;
}

void Emitter::begin_change(const Step& step) {
  if (text_.unrolls()) return entries_.write(text_);
  text_.begin_change(step);
}

// F and its mode as the original has them, before a block that counts on them.
void Emitter::restore_feed_state(const Step& step, bool has_feed_word) {
  const bool cuts = std::any_of(step.motions.begin(), step.motions.end(), [](const Motion& m) {
    return m.kind == MotionKind::feed || m.kind == MotionKind::arc || m.kind == MotionKind::probe;
  });
  line_.clear();
  const bool counts_on_it = step.loses_position || step.saves_modes;  // M70 keeps F, M72 looks whether it is another
  if (control_.feed_mode != step.before->feed_mode && (cuts || counts_on_it)) {
    line_ += codes_.feed_mode(step.before->feed_mode);
    control_.feed_mode = step.before->feed_mode;
    control_.drop_feed();
  }
  const bool turns = std::any_of(step.motions.begin(), step.motions.end(), turns_alone);
  const double feed = turns ? step.before->feed_rotary : step.before->feed;
  const bool needs_feed = (cuts && !has_feed_word) || counts_on_it;
  if (needs_feed && control_.feed_mode != FeedMode::inverse_time && feed > 0 &&
      (turns ? control_.feed_rotary : control_.feed) != feed) {
    append_word(line_, 'F', feed, kMostDecimals, {false, false, spelling_.point, spelling_.most_digits});
    control_.set_feed(feed);
  }
  if (line_.empty()) return;
  line_ += text_.line_end(step);
  text_.write(line_);
}

void Emitter::copy(const Step& step) {
  follow(step);
  const Block& block = *step.block;
  const BlockCodes codes = codes_.codes_of(block);
  if (step.role == BlockRole::stores_position) refuse_if_shifted(step, control_);
  if (text_.changed()) refuse_if_turned(step, control_);
  if (step.cycle != CycleForm::none) note_cycle_level(step);
  if (step.block_delete == BlockDelete::left_out) return leave_out(step);
  const bool offset_words = step.role == BlockRole::sets_offset && shifts_words(step, offset_shift(step, control_));
  const bool motion_missing = text_.changed() && !step.motions.empty() && codes.motion == nullptr &&
                              control_.motion != step.after->motion &&
                              (step.role == BlockRole::plain || (step.call != nullptr && !step.named.empty())) &&
                              step.motions.front().kind != MotionKind::dwell;
  if (offset_words) refuse_shared_offset(step, codes);
  if (offset_words || text_.unrolls()) begin_change(step);
  const bool merges = merges_points(step, codes);
  if (merges) refuse_shared_path(step, codes, dialect_);
  if (!text_.changed() && (merges || step.block_delete == BlockDelete::executed)) hold_changed(step, merges);
  if (text_.changed()) {
    refuse_point_without_code(step, codes, control_.motion);
    const std::uint64_t begin = text_.size();
    restore_feed_state(step, codes.feed != nullptr);
    editor_.start(block, spelling_);
    drop_slash(editor_, step);
    if (merges) keep_each_point(editor_, block);
    if (offset_words) add_offset_shifts(step);
    if (motion_missing) {
      const Word* first = first_axis_word(block);
      if (first == nullptr) first = &block.words.front();
      editor_.insert_before(first->span.begin, codes_.motion(step.after->motion));
      control_.motion = step.after->motion;
    }
    line_.clear();
    editor_.apply(line_);
    text_.write_line(step, line_);
    text_.end_block(step);
    text_.note_replaced(step, begin, line_);
  }
  control_.follow(step, codes);
}

// The control works the offset out from where it stands; its words grow by what it is off, so that the offset is the
// one that the original gives.
void Emitter::add_offset_shifts(const Step& step) {
  const AxisWords shift = offset_shift(step, control_);
  for (const Word& word : step.block->words) {
    const std::optional<Axis> axis = axis_of(word.letter);
    if (!axis || std::abs(shift[*axis]) <= 1e-9) continue;
    const double exact = word.value + shift[*axis] / step.after->unit_of(*axis);
    const double kept = planner_.words().offset_word(step, *axis, exact);
    if (std::abs(kept - exact) > kSameOffset) {
      refuse_block(*step.block, "emit-stores-position",
                   fmt::format("{} sets an offset from where the control stands, which after the correction is no "
                               "multiple of what it keeps of a word",
                               letter(*axis)),
                   "write G20, G21 and G68 after this block, or move there in machine coordinates (G53) first");
    }
    std::string text;
    append_word(text, word.letter, kept, kMostDecimals,
                {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    editor_.replace(word.span, text);
  }
}

// As the block reads if anything is changed behind it. Block delete: what the control's switch would decide is decided
// in the text.
void Emitter::hold_changed(const Step& step, bool merges) {
  std::string text;
  editor_.start(*step.block, spelling_);
  drop_slash(editor_, step);
  if (merges) keep_each_point(editor_, *step.block);
  editor_.apply(text);
  text_.hold(step, text);
}

void Emitter::leave_out(const Step& step) {
  const std::string text = comment_line(kSkipped, dialect_);
  if (text_.unrolls()) begin_change(step);
  if (!text_.changed()) return text_.hold(step, text);
  const std::uint64_t begin = text_.size();
  text_.write_line(step, text);
  text_.end_block(step);
  line_ = text;
  text_.note_replaced(step, begin, line_);
}

EmittedMove Emitter::move(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                          std::optional<double> seconds) {
  PLUMBLINE_CHECK(step.motions.size() == 1 && !points.empty());
  if (!text_.changed()) control_.adopt(*step.before);
  if (planner_.words().stays(step, points, writable, control_)) {
    copy(step);
    return {false, 1, seconds, 0};
  }
  return rewrite(step, points, writable, seconds);
}

EmittedMove Emitter::rewrite(const Step& step, std::span<const CorrectedPoint> points, AxisSet writable,
                             std::optional<double> seconds) {
  PLUMBLINE_CHECK(step.motions.size() == 1 && !points.empty());
  const BlockCodes codes = codes_.codes_of(*step.block);
  refuse_if_shared(step, codes);
  refuse_beside_unit(step, dialect_);
  if (merges_points(step, codes)) refuse_shared_path(step, codes, dialect_);
  follow(step);
  begin_change(step);
  const std::uint64_t begin = text_.size();
  const std::span<Piece> pieces = planner_.plan(step, points, writable, seconds, control_);
  refuse_doubtful_increments(step, pieces);
  if (pieces.size() > 1) refuse_builders_codes(step, dialect_);
  std::string_view line;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool is_last = i + 1 == pieces.size();
    line = spell(step, i, codes);
    control_.motion = pieces[i].mode(step);
    text_.write_line(step, line);
    if (is_last) {
      text_.end_block(step);
    } else {
      text_.write(text_.line_end(step));
    }
  }
  text_.note_replaced(step, begin, line);
  return {true, static_cast<int>(pieces.size()), planner_.seconds(), planner_.rounding_mm()};
}

// One of the pieces of the block, without its line end. Holds until the next call.
std::string_view Emitter::spell(const Step& step, std::size_t i, const BlockCodes& codes) {
  const Piece& piece = planner_.pieces()[i];
  const bool is_last = i + 1 == planner_.pieces().size();
  line_.clear();
  if (i > 0) {
    writer_.append_further(line_, step, piece, spelling_, codes, control_.motion, is_last);
    return line_;
  }
  const auto in_place = writer_.in_place(step, piece, spelling_, codes, control_.motion, is_last);
  if (in_place) return *in_place;
  writer_.append_first(line_, step, piece, spelling_, codes, control_.motion, is_last);
  if (is_blank_line(line_)) line_ = comment_line(kAllStand, dialect_);
  return line_;
}

void Emitter::steer(const Step& step) {
  const Block& block = *step.block;
  if (step.saves_modes && block.words.size() > 1) {
    refuse_block(block, "emit-modes", "this block keeps or restores modes and does something else as well",
                 "put M70 to M73 into a block of its own");
  }
  const bool other_length = step.frame->tool != tool_;
  follow(step);
  if (step.flow && step.flow->kind != FlowEntry::Kind::none) entries_.note(*step.flow);
  write_restored_modes(step, other_length, codes_, spelling_, control_, [&](const std::string& line) {
    if (line.empty()) return;
    entries_.write(text_);
    text_.write_own_line(line);
  });
}

void Emitter::add_line(const Step& step, const std::string& line) {
  follow(step);
  entries_.write(text_);
  text_.write_own_line(line);
}

void Emitter::begin_group(const Step& step) {
  refuse_builders_codes(step, dialect_);
  if (merges_points(step, codes_.codes_of(*step.block))) {
    refuse_block(*step.block, "emit-shared-words", "G64 stands beside a move that is written out as several",
                 "put it into a block of its own before");
  }
  follow(step);
  begin_change(step);
  text_.begin_group();
  end_modal_call(step);
}

void Emitter::end_group(const Step& step) { text_.end_group(step); }

}  // namespace plumbline::nc
