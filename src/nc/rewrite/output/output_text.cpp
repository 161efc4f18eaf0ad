#include "nc/rewrite/output/output_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.hpp"
#include "nc/language/comment_line.hpp"
#include "nc/rewrite/output/emit_text.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kCopyChunk = std::size_t{1} << 16U;
constexpr std::size_t kTail = 256;  // bytes in which the last % of a file is looked for

bool ends_in_percent(const InputFile& source) {
  std::string tail(kTail, '\0');
  tail.resize(source.read(source.size() - std::min<std::uint64_t>(source.size(), kTail), tail.data(), tail.size()));
  const std::size_t last = tail.find_last_not_of(" \t\r\n");
  if (last == std::string::npos || tail[last] != '%') return false;
  const std::size_t before = tail.find_last_not_of(" \t", last == 0 ? 0 : last - 1);
  return last > 0 && before != std::string::npos && tail[before] == '\n';  // not that of $NAME.MIN%
}

}  // namespace

std::string_view OutputText::line_end(const Step& step) const {
  if (unrolls_) return newline_;
  return step.block->line_end.empty() ? std::string_view(newline_) : step.block->line_end;
}

void OutputText::end_block(const Step& step) {
  out_.write(unrolls_ ? std::string_view(newline_) : step.block->line_end);
}

void OutputText::copy_source(std::uint64_t from, std::uint64_t to) {
  std::string chunk;
  while (from < to) {
    chunk.resize(std::min<std::uint64_t>(kCopyChunk, to - from));
    const std::size_t got = source_.read(from, chunk.data(), chunk.size());
    PLUMBLINE_CHECK(got > 0);
    out_.write(std::string_view(chunk).substr(0, got));
    from += got;
  }
}

// The stamp stands after %, a program number and the comments that the program begins with; with a guard after the
// definitions, too, which a SINUMERIK takes before all other blocks alone [V 1.1.5].
void OutputText::follow(const Step& step) {
  const Block& block = *step.block;
  source_end_ = block.offset + block.text.size() + block.line_end.size();
  if (!block.line_end.empty() && (in_header_ || !unrolls_) && newline_ != block.line_end) newline_ = block.line_end;
  if (block.kind == LineKind::percent && ++percents_ == 1) {
    begins_by_name_ = block.text.find_first_not_of(" \t\r%") != std::string_view::npos;
  }
  if (!in_header_) return;
  const bool number = block.flow.word == FlowWord::program && !block.block_delete;
  const bool steers = block.flow.word != FlowWord::none && !number;  // what it sets is no line of an unrolled program
  const bool rewritten = block.block_delete && !(unrolls_ && steers && step.block_delete != BlockDelete::left_out);
  const bool text = block.words.empty() && (block.settings.empty() || steers) && !rewritten;
  const bool blank = text && block.comments.empty() && block.kind == LineKind::block;
  const bool defines = (block.flow.word == FlowWord::define || block.flow.word == FlowWord::sub) &&
                       dialect_.syntax.declared && !settings_.guard.empty() && !rewritten;
  if (block.kind == LineKind::percent || (text && !block.comments.empty()) || number || defines) {
    header_end_ = source_end_;
  } else if (!blank) {
    in_header_ = false;
    if (unrolls_) write_stamp();
  }
}

void OutputText::write_stamp() {
  for (const std::string& line : settings_.stamp) out_.write(comment_line(line, dialect_) + newline_);
  guard_span_.first = out_.size();
  for (const std::string& line : settings_.guard) out_.write(line + newline_);
  guard_span_.second = out_.size();
}

// Nothing was written as long as nothing had to change; now the text up to this block goes out, the stamp in it.
void OutputText::begin_change(const Step& step) {
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

void OutputText::hold(const Step& step, const std::string& text) {
  const Block& block = *step.block;
  if (only_looks_) return;
  before_change_.push_back({block.offset, std::string(block.text), text});
}

// What was written since `begin` stands for the block, unless it is the block.
void OutputText::note_replaced(const Step& step, std::uint64_t begin, std::string_view line) {
  if (undo_ == nullptr || group_begin_ || unrolls_) return;
  const Block& block = *step.block;
  const std::string_view original = block.text;
  const std::uint64_t size = out_.size() - begin;
  if (size == original.size() + block.line_end.size() && line == block.text) return;
  undo_->replaced(begin, size, std::string(original) + std::string(block.line_end));
}

void OutputText::write_line(const Step& step, std::string_view text) {
  if (text.size() > dialect_.line_length && longest_line(text) > dialect_.line_length) {
    refuse_block(*step.block, "emit-line-too-long",
                 fmt::format("the corrected block has {} characters, and {} takes {}", text.size(), dialect_.name,
                             dialect_.line_length),
                 "put comments or other words of this block on a line of their own");
  }
  out_.write(text);
}

void OutputText::begin_group() { group_begin_ = out_.size(); }

void OutputText::end_group(const Step& step) {
  const std::uint64_t begin = group_begin_.value();
  group_begin_.reset();
  note_replaced(step, begin, {});
}

void OutputText::finish() {
  if (!changed_) copy_source(0, source_.size());
  if (unrolls_ && percents_ == 1 && !(begins_by_name_ && !ends_in_percent(source_))) out_.write("%" + newline_);
}

}  // namespace plumbline::nc
