// Input that can be sought in, and that is noticed to change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/files/descriptor.hpp"
#include "base/files/source.hpp"
#include "base/platform/platform.hpp"

namespace plumbline {

/// Bytes of the longest line of a text, of which there may be no end.
inline constexpr std::uint64_t kLongestLine = 100'000'000;

/// Bytes that a pipe or a device may give: they are kept, and there may be no end of them.
inline constexpr std::uint64_t kMostPiped = 2'000'000'000;

/// Refuses a longer line with file-endless-line.
[[noreturn]] void refuse_endless_line(const std::string& path);

/// Counts what a pipe or a device gives, by its name for the user.
class PipedText {
 public:
  explicit PipedText(std::string name, std::uint64_t most = kMostPiped) : name_(std::move(name)), most_(most) {}
  /// Refuses with file-endless-line, and with file-too-large what is more than that in all.
  void take(std::string_view chunk);

 private:
  std::string name_;
  std::uint64_t most_, line_ = 0, all_ = 0;
};

/// A file, or a text in memory, open for reading at any offset. Standard input ("-"), a pipe or a device is copied to
/// an unnamed temporary file first. Refuses with file-missing, file-is-folder or file-unreadable, and what a pipe or a
/// device gives as PipedText does.
class InputFile {
 public:
  explicit InputFile(const Source& source);
  virtual ~InputFile() = default;
  InputFile(InputFile&&) = default;
  InputFile& operator=(InputFile&&) = default;

  /// As the user wrote it; "<stdin>" for standard input.
  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  /// Reads up to `count` bytes at `offset`; returns how many there were.
  virtual std::size_t read(std::uint64_t offset, char* into, std::size_t count) const;
  /// True if `path` names this very file, links followed.
  bool is_same_as(const std::string& path) const;
  /// To be called when all was read that is used. Refuses with file-changed if it was written to, cut or replaced since
  /// it was opened: what was read may then be part of both.
  virtual void check_unchanged() const;

 protected:
  struct Unopened {
    std::string name;
  };
  /// For who gives bytes of its own.
  explicit InputFile(Unopened file) : name_(std::move(file.name)) {}

 private:
  void open(const std::string& path);
  void spool(int from);
  [[noreturn]] void refuse_changed() const;

  std::string name_;
  std::shared_ptr<const std::string> text_;  // null: a file
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
  platform::FileStatus state_;
  bool is_spooled_ = false;
};

/// The whole of a small file (models, tables). Refuses as InputFile does, and with file-too-large beyond a gigabyte.
std::string read_text(const Source& source);

}  // namespace plumbline
