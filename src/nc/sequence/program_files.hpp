// The files that a program is made of: its own, and those of subprograms beside it. Which of them is read, and where.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/files/files.hpp"
#include "nc/language/dialect.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::nc {

/// Where a line begins, in one of the files.
struct FilePlace {
  std::size_t file = 0;  // 0: the program's own
  LinePlace line;
};

class ProgramFiles {
 public:
  /// Both must outlive it. Reading begins with the program's first line.
  ProgramFiles(const InputFile& program, const Dialect& dialect);

  /// The next line of the file that is read; false at its end.
  bool next(Line& line) { return reading().lines.next(line); }
  /// Of the line that next() gives.
  FilePlace here() const { return {current_, reading().lines.place()}; }
  /// Of the file that is read.
  const std::string& name() const { return reading().file->name(); }
  std::size_t current() const { return current_; }
  bool in_program() const { return current_ == 0; }

  void go_to(const FilePlace& place);
  /// Within the file that is read.
  void seek(const LinePlace& place) { reading().lines.seek(place); }

  /// Opens the file beside the program that holds this subprogram, and gives its number; nothing if there is none.
  std::optional<std::size_t> open_beside(const std::string& subprogram);
  /// The same of a file that may be open, be it the program itself: the number that it has.
  std::optional<std::size_t> beside(const std::string& subprogram);
  std::size_t size() const { return files_.size(); }
  const InputFile& file(std::size_t number) const { return *files_[number]->file; }
  /// Refuses with file-changed where one that was read changed meanwhile.
  void check_unchanged() const;

 private:
  std::optional<std::size_t> open(const std::filesystem::path& path);

  struct File {
    std::unique_ptr<InputFile> opened;  // null for the program itself
    const InputFile* file;
    LineSource lines;
  };
  File& reading() { return *files_[current_]; }
  const File& reading() const { return *files_[current_]; }

  const Dialect& dialect_;
  std::vector<std::unique_ptr<File>> files_;
  std::size_t current_ = 0;
};

}  // namespace plumbline::nc
