// Many outputs that do not belong together, and appear with few syncs.
#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <string>

#include "base/diagnostic.hpp"
#include "base/files/descriptor.hpp"
#include "base/files/destination.hpp"
#include "base/files/file_state.hpp"
#include "base/files/output_target.hpp"
#include "base/files/temporary_file.hpp"

namespace plumbline {

/// A file under a passing name in the folder where it will appear; gone with this unless its group lets it appear.
class WaitingOutput {
 public:
  /// The folder must be there. What processes that were killed left in it is not looked for: sweep_temporary_files
  /// does. Refuses as output_target does, and with file-unwritable, so too what is no file.
  explicit WaitingOutput(const std::string& name);

  /// Writes into it, once; must not outlive it.
  Destination destination();
  const std::string& name() const { return name_; }
  std::uint64_t hash() const { return hash_; }
  std::uint64_t size() const { return size_; }
  /// Of what was written, and of the file that appears. Nothing where the system does not tell.
  std::optional<FileState> state() const { return file_state(file_->descriptor.number()); }

 private:
  friend class OutputGroup;
  void write(std::string_view bytes);
  [[noreturn]] void refuse_write(int error) const;
  void last();
  void appear();

  std::string name_;
  OutputTarget target_;
  std::optional<TemporaryFile> file_;
  std::uint64_t hash_;
  std::uint64_t size_ = 0;
};

/// Appear in the order in which they were added, those of one folder while it is locked. To make thousands of small
/// files last one by one would take the disk longer than to make them.
class OutputGroup {
 public:
  /// All must outlive it.
  void add(WaitingOutput& output) { outputs_.push_back({&output, std::nullopt}); }
  /// All of them last, still under their passing names.
  void make_last();
  /// Each takes its name that could be made to last.
  void appear();
  /// What was in the way of an output; nothing if it is there.
  const std::optional<Diagnostic>& problem(const WaitingOutput& output) const;

 private:
  struct One {
    WaitingOutput* output;
    std::optional<Diagnostic> problem;
  };
  std::list<One> outputs_;
};

}  // namespace plumbline
