// Output that appears whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/files/descriptor.hpp"
#include "base/files/destination.hpp"
#include "base/files/output_target.hpp"
#include "base/files/temporary_file.hpp"
#include "base/text/hash.hpp"

namespace plumbline {

/// A file being written: a temporary one beside the place where it will appear, which takes its name at commit().
/// Without commit() nothing is left behind. A link stays one: the file that it leads to is made or replaced, with its
/// permissions and owner kept. "-", an open file (/dev/stdout), a device, a pipe or who takes the bytes gets them at
/// commit() and is never replaced. Several that belong together are an OutputSet. Refuses as output_target does, and
/// with file-unwritable.
class OutputFile {
 public:
  explicit OutputFile(const Destination& to);
  OutputFile(OutputFile&&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() = default;

  void write(std::string_view bytes) {
    buffer_.append(bytes);
    size_ += bytes.size();
    if (buffer_.size() >= kBuffered) flush();
  }
  std::uint64_t size() const { return size_; }
  /// From now on hash() is the fnv1a of all that is written. To be called before the first write.
  void keep_hash() { hash_ = fnv1a({}); }
  std::uint64_t hash() const { return hash_ ? fnv1a(buffer_, *hash_) : 0; }
  const std::string& name() const { return path_; }
  /// A file of this name appears: it is neither an open file nor somebody who takes the bytes.
  bool is_file() const { return target_.kind == OutputTarget::Kind::file; }
  /// Writes what was written so far into another, too.
  void copy_to(OutputFile& other);
  /// Forgets all that was written.
  void restart();
  void commit();

  /// Hands the system all that was written so far.
  void flush();
  /// Reads back up to `count` bytes at `offset` of what was flushed; returns how many there were. May be called by
  /// another thread than the one that writes.
  std::size_t read(std::uint64_t offset, char* into, std::size_t count) const;

 private:
  friend class OutputSet;
  static constexpr std::size_t kBuffered = std::size_t{1} << 18U;
  void finish();
  void send();
  void hand_over();
  [[noreturn]] void refuse_write(int error, std::string_view also = {}) const;
  std::string path_;
  Destination::Taker take_;  // empty: nobody
  OutputTarget target_;
  std::optional<PassingName> temporary_;  // of a file yet to appear
  Descriptor descriptor_;
  std::string buffer_;
  std::uint64_t size_ = 0;
  std::optional<std::uint64_t> hash_;  // of what was flushed
};

/// Writes a small file whole, as OutputFile does.
void write_text(const std::string& path, std::string_view text);

}  // namespace plumbline
