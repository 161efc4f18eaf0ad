#include "compensate/read_back/output_check.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "compensate/read_back/block_effects.hpp"
#include "compensate/read_back/difference.hpp"
#include "nc/language/comment_line.hpp"

namespace plumbline::compensate {
namespace {

constexpr std::size_t kShownText = 120;

// The output tilts the tool by corrections as well: where a length of a tilted tool changes, the original says.
nc::ProgramSettings settings_of_output(nc::ProgramSettings program, const bool& tilted_length) {
  program.original_tilted = &tilted_length;
  return program;
}

}  // namespace

OutputCheck::OutputCheck(const InputFile& source, const InputFile& output, const nc::Dialect& dialect,
                         const nc::ProgramSettings& program, const nc::EmitSettings& emit, bool unrolled)
    : source_(source),
      dialect_(dialect),
      settings_(program),
      emit_(emit),
      program_(output, dialect, settings_of_output(program, tilted_length_)),
      drops_labels_(unrolled && dialect.syntax.labels == nc::Labels::sequence_names),
      effects_(unrolled),
      moves_(dialect, emit.time_tolerance, figures_) {}

void OutputCheck::take(const IntendedBatch& batch) {
  if (batch.unchanged_blocks > 0) take_unchanged(batch.unchanged_blocks);
  for (const IntendedBlock& block : batch.blocks) take_block(batch, block);
}

// Blocks before the first that changed are in the output as they stand: what they mean is read from the original.
void OutputCheck::take_unchanged(std::uint64_t blocks) {
  nc::ProgramSettings settings = settings_;
  settings.upright_deg = nc::kOwnTiltDeg;
  nc::Program original(source_, dialect_, settings);
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
  tilted_length_ = block.tilted_length;
  steps_ = numbers_ = 0;
  effects_.begin(batch, block);
  moves_.begin(batch, block);
  ++figures_.blocks;
  try {
    while (block.one_step ? steps_ == 0 : read_to_ < block.output_end) {
      if (next() == nullptr) differ("the output ends before it");
      if (!is_stamp()) take_step();
    }
    finish_block();
  } catch (Difference& difference) {
    differ(std::move(difference.what));
  }
}

const nc::Step* OutputCheck::next() {
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
  return step_;
}

// A block of the stamp or the guard, for which the original is no reason.
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
  if (block.at(block.comments.front().span) != nc::comment_line(emit_.stamp[stamp_], dialect_)) return false;
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
    if (drops_labels_) labels_.emplace(block_->number);
  }
  read_effects_.clear();
  append_effects(step, dialect_, read_effects_);
  const auto take = [&](bool behind_motion) {
    for (const BlockEffect& effect : read_effects_) {
      if (effect.behind_motion == behind_motion && effects_.take(effect, *step.block)) check_turn(effect);
    }
  };
  take(false);
  moves_.take(step);
  take(true);
}

void OutputCheck::check_turn(const BlockEffect& effect) {
  if (effect.behind_motion) return moves_.end();
  if (moves_.has_moved()) differ(fmt::format("{} comes after the move", text_of(effect)));
}

void OutputCheck::finish_block() {
  moves_.end();
  effects_.end();
  const bool bears_it = numbers_ > 0 || labels_.contains(block_->number);  // a label stands where it comes first
  if (!block_->number.empty() && !block_->steers && moves_.has_moved() && !bears_it) {
    differ(fmt::format("its number {} is missing", block_->number));
  }
  if (step_ == nullptr) return;
  const std::string other = difference(batch_->states[block_->state], *step_->after, *step_->frame);
  if (!other.empty()) differ(fmt::format("{} after it is not as it was meant", other));
}

void OutputCheck::finish() {
  while (next() != nullptr) {
    if (is_stamp()) continue;
    read_effects_.clear();
    if (step_->block->kind != nc::LineKind::ignored) append_effects(*step_, dialect_, read_effects_);
    const bool nothing = std::all_of(read_effects_.begin(), read_effects_.end(),
                                     [](const BlockEffect& effect) { return effect.text == "%"; });
    if (!nothing || !step_->motions.empty()) differ("the output goes on after the end");
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
