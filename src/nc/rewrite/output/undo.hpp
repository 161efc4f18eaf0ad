// What a rewritten program replaced, so that the original can be had back byte for byte.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/files/files.hpp"

namespace plumbline::nc {

/// Writes an undo file: a header line, then for each changed span of the output where it begins, how long it is, and
/// the bytes of the original that it stands for; last the sizes and hashes of both files. Spans that touch become one.
class UndoLog {
 public:
  /// `file` must outlive it and is left for the caller to commit.
  explicit UndoLog(OutputFile& file);

  /// Bytes [offset, offset + size) of the output stand for `original`. Offsets do not decrease.
  void replaced(std::uint64_t offset, std::uint64_t size, std::string_view original);
  /// Forgets all of it: the whole output stands for the whole original, whose order it does not keep.
  void replaced_all();
  /// To be called last, with both files whole.
  void finish(const InputFile& original, std::uint64_t output_size, std::uint64_t output_hash);

 private:
  void flush();
  OutputFile& file_;
  std::uint64_t offset_ = 0;
  std::uint64_t size_ = 0;
  std::string original_;
  bool holds_ = false;
  bool all_ = false;
};

/// Writes the original that `rewritten` was made from. Undo files may hold one part after the other; the one that fits
/// counts. Refuses with undo-format where the undo file is none or is cut short, undo-mismatch where it belongs to
/// another program, or the program was changed since; before anything is written, but where the undo file itself was
/// changed.
void restore(const InputFile& rewritten, const InputFile& undo, OutputFile& out);

/// Appends to `into`, an undo file that is finished, the part of `undo` that fits `rewritten`: it serves both then.
/// False if none fits. Refuses with undo-format.
bool copy_undo(const InputFile& rewritten, const InputFile& undo, OutputFile& into);

/// fnv1a of a whole file.
std::uint64_t hash_of(const InputFile& file);

}  // namespace plumbline::nc
