// A program, executed block by block: read, parsed, interpreted. Memory does not grow with its length.
#pragma once

#include <memory>

#include "base/files/files.hpp"
#include "nc/control/state/program_settings.hpp"
#include "nc/control/step.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// Pulls a program through lexer, parser and interpreter.
class Program {
 public:
  /// `file` and `dialect` must outlive it.
  Program(const InputFile& file, const Dialect& dialect, ProgramSettings settings);
  ~Program();
  Program(Program&&) = delete;
  Program& operator=(Program&&) = delete;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Executes the next block; null at the end. As long as nothing jumped the texts of all blocks, with their line ends,
  /// put one after the other are the file. Refuses with nc-... and the place of what it cannot take,
  /// and at the end with file-changed where a file was written to meanwhile.
  const Step* next();
  /// The block of the last step, which goes on pointing to it, for who keeps it; its text holds until next() all the
  /// same. `instead` is filled by next().
  std::unique_ptr<Block> exchange_block(std::unique_ptr<Block> instead);
  /// True once something jumped or repeated before the block of the last step: steps are not in the order of the text.
  bool jumped() const;
  /// True once an expression read where the control stands, which differs in a rewritten program.
  bool position_read() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The axes that some word of the program names, or of a subprogram beside it that it calls by a plain name; found
/// without executing it. Files of subprograms are those of the dialect.
AxisSet named_axes(const InputFile& file, const Dialect& dialect);

}  // namespace plumbline::nc
