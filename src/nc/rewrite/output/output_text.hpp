// The text of the output as it grows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/files.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"
#include "nc/rewrite/output/emit_settings.hpp"
#include "nc/rewrite/output/undo.hpp"

namespace plumbline::nc {

/// Copies the source up to the first change, with the stamp after its header; from there on takes lines, and notes
/// what they replaced. Unrolled, the stamp is written once the header is over, and nothing is copied.
class OutputText {
 public:
  /// All must outlive it.
  OutputText(const InputFile& source, const Dialect& dialect, const EmitSettings& settings, OutputFile& out,
             bool unrolls)
      : source_(source), dialect_(dialect), settings_(settings), out_(out), unrolls_(unrolls), changed_(unrolls) {}

  void record(UndoLog& log) { undo_ = &log; }
  void only_look() { only_looks_ = true; }
  bool unrolls() const { return unrolls_; }
  bool changed() const { return changed_; }
  std::uint64_t size() const { return out_.size(); }
  std::pair<std::uint64_t, std::uint64_t> guard_span() const { return guard_span_; }

  /// To be called with each step before its text: finds the end of the header, and how lines end.
  void follow(const Step& step);
  /// From this block on what is written is not the source: what stands before it goes out now.
  void begin_change(const Step& step);
  /// In text order, before anything changed: the block's text becomes this one, should there be a change later.
  void hold(const Step& step, const std::string& text);

  /// Text of the block, without its line end. Refuses with emit-line-too-long.
  void write_line(const Step& step, std::string_view text);
  /// Whole lines, with their ends.
  void write(std::string_view text) { out_.write(text); }
  void write_own_line(std::string text) { out_.write(text += newline_); }
  void end_block(const Step& step);
  std::string_view line_end(const Step& step) const;

  /// What was written since `begin`, with `line` as its last line, stands for the block, unless it is the block.
  void note_replaced(const Step& step, std::uint64_t begin, std::string_view line);
  void begin_group();
  void end_group(const Step& step);

  /// Unrolled, after the last block: what stands from here to the end of the source, as it is.
  void carry_over(std::uint64_t begin) { copy_source(begin, source_.size()); }
  /// To be called after the last block.
  void finish();

 private:
  struct Replacement {  // of a whole block's text, before anything else of the program was changed
    std::uint64_t offset;
    std::string original;
    std::string text;
  };

  void copy_source(std::uint64_t from, std::uint64_t to);
  void write_stamp();

  const InputFile& source_;
  const Dialect& dialect_;
  const EmitSettings& settings_;
  OutputFile& out_;
  bool unrolls_;
  bool changed_;
  UndoLog* undo_ = nullptr;
  bool only_looks_ = false;
  std::optional<std::uint64_t> group_begin_;  // of the text of blocks that stand for one together
  std::pair<std::uint64_t, std::uint64_t> guard_span_;
  int percents_ = 0;
  bool begins_by_name_ = false;  // $NAME.MIN%, after which the file may end without %
  bool in_header_ = true;
  std::uint64_t header_end_ = 0;
  std::uint64_t source_end_ = 0;
  std::string newline_ = "\n";
  std::vector<Replacement> before_change_;
};

}  // namespace plumbline::nc
