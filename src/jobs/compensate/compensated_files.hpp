// What a compensation writes: the program, its undo file and reports of it, which appear as one.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files/files.hpp"
#include "nc/rewrite/output/undo.hpp"

namespace plumbline::jobs {

class CompensatedFiles {
 public:
  /// Opens all of them, so that one that cannot be written shows before the work. `undo`: none, or where it goes, which
  /// is undo_name() of the output if that is a file. `reports`: the files that tell of it, `tells_hash` whether its
  /// hash.
  CompensatedFiles(const Destination& output, const std::optional<Destination>& undo,
                   const std::vector<std::string>& reports, bool tells_hash = true);

  OutputFile& program() { return program_; }
  /// Somebody is told the hash of the program.
  bool keeps_hash() const { return keeps_hash_; }
  /// Null: none is wanted.
  nc::UndoLog* undo_log() { return undo_ ? &undo_->log : nullptr; }
  /// In the order in which they were named; to be written before commit().
  std::list<OutputFile>& reports() { return reports_; }
  /// All appear, the reports first, the program last. At every moment, whatever becomes of this
  /// process, the undo file that stands beside the program serves it: between the two steps it serves the program that
  /// stood there before as well.
  void commit(const InputFile& original);

 private:
  struct Undo {
    explicit Undo(const Destination& to) : file(to), log(file) {}
    OutputFile file;
    nc::UndoLog log;
  };
  bool join_old_undo(OutputFile& both) const;

  OutputFile program_;
  bool keeps_hash_;
  std::optional<Undo> undo_;
  std::list<OutputFile> reports_;
};

/// Where --undo puts what the output replaced: beside it.
std::string undo_name(const std::string& output);

/// A program and its undo file, opened while nobody replaces them. Refuses as InputFile does.
std::pair<InputFile, InputFile> open_pair(const Source& program, const Source& undo);

}  // namespace plumbline::jobs
