// Files: input that can be sought in, output that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/hash.hpp"

namespace plumbline {

/// The name by which standard input and output are asked for on the command line.
inline constexpr std::string_view kStandardStream = "-";

/// An open file by its number, closed when this goes.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }
  /// Hands the number over to the caller, who closes it.
  int release() { return std::exchange(number_, -1); }
  /// Closes it now; false if the system could not keep what was written.
  bool close();

 private:
  int number_ = -1;
};

/// A file open for reading at any offset. Standard input ("-"), a pipe or a device is copied to an unnamed temporary
/// file first.
/// Refuses with file-missing, file-is-folder or file-unreadable.
class InputFile {
 public:
  explicit InputFile(const std::string& path);

  /// As the user wrote it; "<stdin>" for standard input.
  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  /// Reads up to `count` bytes at `offset`; returns how many there were.
  std::size_t read(std::uint64_t offset, char* into, std::size_t count) const;
  /// True if `path` names this very file, links followed.
  bool is_same_as(const std::string& path) const;

 private:
  void open(const std::string& path);
  void spool(int from);

  std::string name_;
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
};

/// The whole of a small file (models, tables). Refuses as InputFile does, and with file-too-large beyond a gigabyte.
std::string read_text(const std::string& path);

/// A file being written: a temporary one beside `path` that takes its name at commit(). Without commit() nothing is
/// left behind. A link stays one: the file that it leads to is replaced. "-", a device or a pipe gets its bytes at
/// commit() and is never replaced. Refuses with file-unwritable or file-is-folder.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(OutputFile&&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  std::uint64_t size() const { return size_; }
  /// From now on hash() is the fnv1a of all that is written. To be called before the first write.
  void keep_hash() { hash_ = fnv1a({}); }
  std::uint64_t hash() const { return hash_.value_or(0); }
  const std::string& name() const { return path_; }
  /// Forgets all that was written.
  void restart();
  void commit();

 private:
  void flush();
  void copy_to_stream();
  [[noreturn]] void refuse_write(int error) const;
  std::string path_;
  std::string target_;  // what path_ leads to
  std::string temporary_;
  std::string buffer_;
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
  std::optional<std::uint64_t> hash_;
};

/// Writes a small file whole, as OutputFile does.
void write_text(const std::string& path, std::string_view text);

}  // namespace plumbline
