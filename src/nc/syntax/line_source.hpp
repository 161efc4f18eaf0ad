// Lines of a program file, read in chunks: memory does not grow with the file. Can go on at any line it has seen, which
// is how loops and subprograms jump.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "base/files/files.hpp"
#include "nc/syntax/growing_text.hpp"

namespace plumbline::nc {

/// Where a line begins.
struct LinePlace {
  std::uint64_t offset = 0;
  std::size_t line = 1;
};

struct Line {
  std::string_view text;      // followed by its line end, or by a NUL at the end of the file; may be several lines
  std::string_view line_end;  // "\n", "\r\n" or ""
  LinePlace place;
  bool whole = true;  // false: longer than the window; this is a piece of it
};

/// Characters of the longest of the lines that `text` is made of.
std::size_t longest_line(std::string_view text);

class LineSource {
 public:
  static constexpr std::size_t kWindow = std::size_t{1} << 18U;
  /// `file` must outlive it. Lines that begin with `goes_on` belong to the line before them; 0: none do. A smaller
  /// window is for tests.
  explicit LineSource(const InputFile& file, char goes_on = '\0', std::size_t window = kWindow);

  /// The next line, valid until the call after it; false at the end of the file. Refuses with file-endless-line.
  bool next(Line& line);
  /// The next call of next() gives the line that begins here.
  void seek(LinePlace place);
  /// Of the line that next() gives.
  LinePlace place() const { return place_; }

 private:
  void fill();
  bool goes_on(std::size_t next);
  const InputFile& file_;
  const GrowingText* growing_;  // null: the file is whole
  char goes_on_;
  std::size_t size_;                // of the window
  std::unique_ptr<char[]> window_;  // not zeroed: a short program touches little of it
  std::size_t begin_ = 0;           // of what is not yet handed out, in the window
  std::size_t end_ = 0;             // of what was read
  LinePlace place_;                 // of begin_
  bool middle_ = false;             // begin_ is inside a line longer than the window
  std::uint64_t of_long_line_ = 0;  // bytes of it that were handed out
};

}  // namespace plumbline::nc
