#include "compensate/output_check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/number_text.hpp"
#include "compensate/block_effects.hpp"
#include "compensate/figures.hpp"
#include "nc/emit.hpp"
#include "path/curve.hpp"
#include "path/duration.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kLoose = 1.6;    // halves of what the control keeps: an axis without a word may be left that far off
constexpr double kEndless = 3.2;  // of an axis that turns without end: -0 is stepped over
constexpr double kTimeSlack = 1e-6;   // share of a block's time: the digits of F
constexpr double kSameDwell = 1e-6;   // s
constexpr double kSameCentre = 5e-5;  // mm
constexpr double kNoLength = 1e-9;    // mm and deg
constexpr double kNoTime = 1e-9;      // s
constexpr std::size_t kShownText = 120;

std::string_view name_of(nc::MotionKind kind) {
  switch (kind) {
    case nc::MotionKind::rapid:
      return "a rapid";
    case nc::MotionKind::feed:
      return "a straight cut";
    case nc::MotionKind::arc:
      return "an arc";
    case nc::MotionKind::probe:
      return "a probing move";
    case nc::MotionKind::dwell:
      break;
  }
  return "a dwell";
}

double way(const AxisWords& d) {
  double sum = 0;
  for (const double value : d.values) sum += std::abs(value);
  return sum;
}

// Comments that show nothing and ask for nothing.
bool is_passive(std::string_view comment) {
  for (const std::string_view active : {"msg", "debug", "print", "log", "probeopen", "probeclose", "py", "abort"}) {
    std::size_t at = comment.find_first_not_of("(; \t");
    bool same = at != std::string_view::npos;
    for (const char c : active) {
      same = same && at < comment.size() && (comment[at] | 0x20) == c;
      ++at;
    }
    if (same) return false;
  }
  return true;
}

bool is_bare(const nc::Block& block) {
  return block.words.empty() && block.settings.empty() && block.kind == nc::LineKind::block;
}

}  // namespace

OutputCheck::OutputCheck(const InputFile& source, const InputFile& output, const nc::Dialect& dialect,
                         const nc::ProgramSettings& program, const nc::EmitSettings& emit, bool unrolled)
    : source_(source),
      dialect_(dialect),
      settings_(program),
      emit_(emit),
      program_(output, dialect, program),
      unrolled_(unrolled) {}

void OutputCheck::take(const IntendedBatch& batch) {
  if (batch.unchanged_blocks > 0) take_unchanged(batch.unchanged_blocks);
  for (const IntendedBlock& block : batch.blocks) take_block(batch, block);
}

// Blocks before the first that changed are in the output as they stand: what they mean is read from the original.
void OutputCheck::take_unchanged(std::uint64_t blocks) {
  nc::Program original(source_, dialect_, settings_);
  Intention intention(source_, dialect_, emit_, false);
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const nc::Step* const step = original.next();
    PLUMBLINE_CHECK(step != nullptr);
    intention.start_batch();
    intention.begin(*step);
    intention.keep(*step, true);
    intention.end(0);
    IntendedBatch& batch = intention.batch();
    batch.blocks.back().one_step = true;
    take_block(batch, batch.blocks.back());
  }
}

void OutputCheck::take_block(const IntendedBatch& batch, const IntendedBlock& block) {
  batch_ = &batch;
  block_ = &block;
  move_ = block.first_move;
  last_move_ = move_ + block.moves;
  effect_ = block.first_effect;
  last_effect_ = effect_ + block.effects;
  point_ = steps_ = numbers_ = 0;
  spent_ = length_ = 0;
  has_moved_ = stops_ = false;
  ++figures_.blocks;
  while (block.one_step ? steps_ == 0 : read_to_ < block.output_end) {
    if (next() == nullptr) differ("the output ends before it");
    take_step();
  }
  finish_block();
}

// The next block of the output that the original is the reason for: the stamp and the guard are left out.
const nc::Step* OutputCheck::next() {
  do {
    try {
      step_ = program_.next();
    } catch (const Refusal& refusal) {
      output_line_ = refusal.diagnostic().place.line;
      output_text_ = refusal.diagnostic().place.text;
      differ(fmt::format("the output cannot be read, since {}", refusal.diagnostic().message));
    }
    if (step_ == nullptr) return nullptr;
    const nc::Block& block = *step_->block;
    read_to_ = block.offset + block.text.size() + block.line_end.size();
    output_line_ = block.line;
    ++figures_.output_blocks;
  } while (is_stamp());
  return step_;
}

bool OutputCheck::is_stamp() {
  const nc::Block& block = *step_->block;
  const std::size_t lines = emit_.stamp.size();
  if (stamp_ == lines && guard_ < emit_.guard.size()) {
    if (block.text.find_first_not_of(" \t") != std::string_view::npos) differ("the guard of the output is another one");
    ++guard_;
    ++figures_.guard_lines;
    return true;
  }
  if (stamp_ >= lines || !is_bare(block) || block.comments.size() != 1) return false;
  const std::size_t signs = dialect_.comment_open.size() + dialect_.comment_close.size();
  const std::string_view text =
      std::string_view(emit_.stamp[stamp_]).substr(0, dialect_.line_length - std::min(dialect_.line_length, signs));
  const std::string_view comment = block.at(block.comments.front().span);
  if (comment != dialect_.comment_open + std::string(text) + dialect_.comment_close) return false;
  ++stamp_;
  return true;
}

void OutputCheck::take_step() {
  const nc::Step& step = *step_;
  ++steps_;
  if (step.block->has_number()) {
    if (block_->number != step.block->at(step.block->number) || ++numbers_ > 1) {
      differ(fmt::format("it bears the number {}", step.block->at(step.block->number)));
    }
  }
  read_effects_.clear();
  append_effects(step, dialect_, read_effects_);
  for (const BlockEffect& effect : read_effects_) {
    if (!effect.behind_motion) take_effect(effect);
  }
  for (const nc::Motion& motion : step.motions) take_motion(motion);
  for (const BlockEffect& effect : read_effects_) {
    if (effect.behind_motion) take_effect(effect);
  }
  if (!step.motions.empty()) stops_ = step.after->path_control == nc::PathControl::exact_stop;
}

// What no effect of the original is: the comments that the rewriting adds, and modes that come back.
bool OutputCheck::is_ours(const BlockEffect& effect) const {
  if (!effect.is_comment) return block_->steers && effect.is_mode;
  return is_bare(*step_->block) && is_passive(effect.text) &&
         (unrolled_ || block_->left_out || effect.text.find(nc::kAllStand) != std::string::npos);
}

void OutputCheck::take_effect(const BlockEffect& effect) {
  const bool expects = effect_ < last_effect_ && !block_->steers;
  if (expects) {
    const BlockEffect& meant = batch_->effects[effect_];
    const bool silenced = unrolled_ && meant.is_comment && effect.text == "(was " + meant.text.substr(1);
    if (silenced || are_alike(meant, effect)) {
      ++effect_;
      if (!meant.is_comment) check_turn(effect);
      return;
    }
  }
  if (is_ours(effect)) return;
  differ(fmt::format("it has {} where {} was meant", text_of(effect),
                     expects ? text_of(batch_->effects[effect_]) : std::string("nothing")));
}

void OutputCheck::check_turn(const BlockEffect& effect) {
  if (!effect.behind_motion && has_moved_) differ(fmt::format("{} comes after the move", text_of(effect)));
  if (!effect.behind_motion) return;
  while (move_ < last_move_) finish_move();
}

// In the axes of the words, which is where the control rounds.
bool OutputCheck::is_at(const AxisWords& point, const AxisWords& read, const IntendedMove& move, bool has_words) const {
  const AxisWords off = nc::turned_about_z(read - point, -step_->frame->rotation_deg);
  return std::all_of(kAllAxes.begin(), kAllAxes.end(), [&](Axis axis) {
    if (!move.motion.known_after.contains(axis)) return true;
    const bool endless = step_->after->rule_of(axis) != nc::RotaryRule::linear;
    const double halves = endless ? kEndless : has_words && step_->named.contains(axis) ? 1 : kLoose;
    return std::abs(off[axis]) <= halves * move.tolerance[axis];
  });
}

// Its points need no piece: the control stands there already, as far as it can tell.
bool OutputCheck::is_reached(const IntendedMove& move, std::size_t point) const {
  if (move.motion.kind == nc::MotionKind::dwell) return false;
  if (move.form == IntendedMove::Form::kept && stands(move.motion)) return true;
  return stands_known_.contains(move.motion.known_after) &&
         is_at(batch_->points[move.first_point + point], stands_, move, false);
}

void OutputCheck::take_motion(const nc::Motion& motion) {
  if (motion.kind != nc::MotionKind::dwell) has_moved_ = true;
  while (move_ < last_move_) {
    const IntendedMove& meant = batch_->moves[move_];
    const bool taken = meant.form == IntendedMove::Form::kept ? take_kept(meant, motion) : take_piece(meant, motion);
    if (taken) return;
    if (!may_finish(meant)) break;
    finish_move();
  }
  const bool enters = block_->spindle_cycle && motion.kind == nc::MotionKind::rapid;
  if (!stands(motion) && !enters) differ(what_differs(motion));
  go_to(motion);
}

void OutputCheck::go_to(const nc::Motion& motion) {
  if (motion.kind == nc::MotionKind::dwell) return;
  stands_ = motion.machine;
  stands_known_ = motion.known_after;
}

std::string OutputCheck::what_differs(const nc::Motion& motion) const {
  if (move_ >= last_move_) return fmt::format("it has {} more than was meant", name_of(motion.kind));
  const IntendedMove& meant = batch_->moves[move_];
  const bool pieces = meant.form == IntendedMove::Form::pieces;
  const nc::MotionKind kind = pieces && is_cut(meant.motion.kind) ? nc::MotionKind::feed : meant.motion.kind;
  if (kind != motion.kind || meant.motion.in_machine_coordinates != motion.in_machine_coordinates) {
    return fmt::format("it has {} where {} was meant", name_of(motion.kind), name_of(kind));
  }
  if (kind == nc::MotionKind::dwell) {
    return fmt::format("it waits {} s, and {} s were meant", to_decimal(motion.dwell_s, 6),
                       to_decimal(meant.motion.dwell_s, 6));
  }
  const AxisWords& wanted = batch_->points[meant.first_point + std::min(point_, meant.points - 1)];
  for (const Axis axis : kAllAxes) {
    if (meant.motion.known_after.contains(axis) != motion.known_after.contains(axis)) {
      return fmt::format("where {} stands is known only in one of the two", letter(axis));
    }
    if (!meant.motion.known_after.contains(axis)) continue;
    if (std::abs(wanted[axis] - motion.machine[axis]) <= kLoose * meant.tolerance[axis]) continue;
    return fmt::format("it ends at {}{} of the machine, and {} was meant", letter(axis),
                       to_decimal(motion.machine[axis], 6), to_decimal(wanted[axis], 6));
  }
  if (kind == nc::MotionKind::arc) return "its arc is another one";
  return "it ends elsewhere than was meant";
}

bool OutputCheck::take_kept(const IntendedMove& meant, const nc::Motion& motion) {
  const nc::Motion& original = meant.motion;
  if (original.kind != motion.kind || original.in_machine_coordinates != motion.in_machine_coordinates) return false;
  if (original.kind == nc::MotionKind::dwell) {
    const double counted = dialect_.habits.dwell_p_s == 1 ? 0 : dialect_.habits.dwell_p_s / 2;
    if (std::abs(original.dwell_s - motion.dwell_s) > kSameDwell + counted) return false;
    if (meant.counts) figures_.seconds += motion.dwell_s;
    ++move_;
    return true;
  }
  const AxisWords& wanted = batch_->points[meant.first_point];
  if (!(original.known_after == motion.known_after) || !is_at(wanted, motion.machine, meant, true)) return false;
  if (original.kind == nc::MotionKind::arc) {
    bool same = original.arc.plane == motion.arc.plane && original.arc.turns == motion.arc.turns;
    for (std::size_t i = 0; i < original.arc.centre_mm.size(); ++i) {
      same = same && std::abs(original.arc.centre_mm[i] - motion.arc.centre_mm[i]) <= kSameCentre;
    }
    if (!same) return false;
  }
  if (original.kind == nc::MotionKind::probe && std::abs(original.feed - motion.feed) > 1e-6 * original.feed) {
    differ("it probes at another feed");
  }
  spend(motion);
  note_point(meant, wanted, motion);
  go_to(motion);
  check_time(meant);
  leave_move();
  return true;
}

bool OutputCheck::take_piece(const IntendedMove& meant, const nc::Motion& motion) {
  const bool cuts = is_cut(meant.motion.kind);
  const nc::MotionKind kind = cuts ? nc::MotionKind::feed : meant.motion.kind;
  if (motion.kind != kind || motion.in_machine_coordinates) return false;
  if (!(meant.motion.known_after == motion.known_after) && point_ + 1 == meant.points) return false;
  std::size_t at = point_;
  while (at < meant.points && !is_at(batch_->points[meant.first_point + at], motion.machine, meant, true)) {
    if (!is_reached(meant, at)) return false;
    ++at;
  }
  if (at == meant.points) return false;
  if (point_ > 0 && stops_ && cuts) differ("the control would stop between its pieces");
  spend(motion);
  note_point(meant, batch_->points[meant.first_point + at], motion);
  go_to(motion);
  point_ = at + 1;
  return true;
}

void OutputCheck::spend(const nc::Motion& motion) {
  if (!is_cut(motion.kind)) return;
  const path::Curve curve(motion);
  length_ += way(curve.delta()) + curve.linear_mm();
  const IntendedMove& meant = batch_->moves[move_];
  if (!meant.seconds) return;
  const bool turns = meant.motion.feed_mode == nc::FeedMode::per_revolution;
  if (turns != (motion.feed_mode == nc::FeedMode::per_revolution)) differ("its feed is in another unit");
  spent_ += path::duration(motion, curve, dialect_).value_or(0);
}

void OutputCheck::note_point(const IntendedMove& meant, const AxisWords& wanted, const nc::Motion& motion) {
  if (motion.kind == nc::MotionKind::probe || motion.in_machine_coordinates) return;
  ++figures_.points;
  if (!meant.corrected) return;
  AxisWords off;
  for (const Axis axis : kAllAxes) {
    if (motion.known_after.contains(axis)) off[axis] = motion.machine[axis] - wanted[axis];
  }
  figures_.rounding_mm.take(length_mm(off), block_->line);
}

bool OutputCheck::may_finish(const IntendedMove& meant) const {
  if (meant.form == IntendedMove::Form::kept) return is_reached(meant, 0);
  for (std::size_t i = point_; i < meant.points; ++i) {
    if (!is_reached(meant, i)) return false;
  }
  return true;
}

void OutputCheck::finish_move() {
  const IntendedMove& meant = batch_->moves[move_];
  if (!may_finish(meant)) {
    const std::size_t at = std::min(point_, meant.points - 1);
    const AxisWords& wanted = batch_->points[meant.first_point + at];
    differ(fmt::format("{} is missing, which was to end at X{} Y{} Z{} of the machine", name_of(meant.motion.kind),
                       to_decimal(wanted[Axis::X], 6), to_decimal(wanted[Axis::Y], 6), to_decimal(wanted[Axis::Z], 6)));
  }
  check_time(meant);
  leave_move();
}

void OutputCheck::leave_move() {
  ++move_;
  point_ = 0;
  spent_ = length_ = 0;
}

// A move whose end is where it begins, as far as the control can tell, takes no time.
void OutputCheck::check_time(const IntendedMove& meant) {
  if (!meant.seconds || *meant.seconds <= kNoTime) return;
  const bool clock = meant.motion.feed_mode != nc::FeedMode::per_revolution;
  if (meant.counts && clock) figures_.seconds += spent_;
  if (length_ <= kNoLength) return;
  const double change = std::abs(spent_ / *meant.seconds - 1);
  if (change > emit_.time_tolerance + kTimeSlack) {
    differ(fmt::format("it takes {} {}, and {} were meant", to_decimal(spent_, 6), clock ? "s" : "revolutions",
                       to_decimal(*meant.seconds, 6)));
  }
  if (meant.counts && clock) figures_.time_change.take(change, block_->line);
}

void OutputCheck::finish_block() {
  while (move_ < last_move_) finish_move();
  if (!block_->steers && effect_ < last_effect_) {
    differ(fmt::format("{} is missing", text_of(batch_->effects[effect_])));
  }
  if (!block_->number.empty() && !block_->steers && has_moved_ && numbers_ == 0) {
    differ(fmt::format("its number {} is missing", block_->number));
  }
  if (step_ == nullptr) return;
  const std::string other = difference(batch_->states[block_->state], {*step_->after, *step_->frame});
  if (!other.empty()) differ(fmt::format("{} behind it is not as it was meant", other));
}

void OutputCheck::finish() {
  while (next() != nullptr) {
    read_effects_.clear();
    if (step_->block->kind != nc::LineKind::ignored) append_effects(*step_, dialect_, read_effects_);
    const bool nothing = std::all_of(read_effects_.begin(), read_effects_.end(),
                                     [](const BlockEffect& effect) { return effect.text == "%"; });
    if (!nothing || !step_->motions.empty()) differ("the output goes on behind the end");
  }
  if (stamp_ < emit_.stamp.size()) differ("the comments that mark the output are missing");
}

void OutputCheck::differ(std::string what) const {
  Place place;
  place.file = source_.name();
  if (block_ != nullptr) {
    if (!block_->file.empty()) place.file = block_->file;
    place.line = block_->line;
    place.column = 1;
    place.text = line_at(block_->file, block_->offset);
    place.length = std::max<std::size_t>(place.text.size(), 1);
  }
  std::string written = output_text_;
  if (written.empty() && step_ != nullptr) written = step_->block->text;
  refuse(
      "compensate-read-back",
      fmt::format("what was written for this block is not what was meant: {} (line {} of the output: {})", what,
                  output_line_, written.substr(0, kShownText)),
      "this is a bug in plumbline, and nothing was written: please report it with the program; --no-read-back writes "
      "the output all the same",
      std::move(place));
}

std::string OutputCheck::line_at(const std::string& file, std::uint64_t offset) const {
  const std::optional<InputFile> other = file.empty() ? std::nullopt : std::optional<InputFile>(std::in_place, file);
  std::string text(dialect_.line_length, '\0');
  text.resize((other ? *other : source_).read(offset, text.data(), text.size()));
  return text.substr(0, text.find_first_of("\r\n"));
}

}  // namespace plumbline::compensate
