// Files that belong together and appear as one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/files/folder_lock.hpp"
#include "base/files/output_file.hpp"

namespace plumbline {

/// A folder made for what is to be written there, with those above it; what was made of it goes again unless it is
/// kept.
class NewFolder {
 public:
  /// Refuses with file-unwritable.
  explicit NewFolder(const std::string& path);
  void keep();

 private:
  std::vector<PassingName> made_;
};

/// Files that belong together: all are written whole and synced before the first appears, and where one cannot appear
/// the others are taken back. Streams get their bytes before any file appears. Two processes that write the same set do
/// so one after the other.
class OutputSet {
 public:
  /// Files appear in the order in which they are added: last the one that says that the others are there. `file` must
  /// outlive the set.
  void add(OutputFile& file) { files_.push_back(&file); }
  /// What stands where the last file will appear goes away first, so that a process that is killed in between leaves a
  /// set that lacks it, never one of new and old files: for outputs that can be made again.
  void clear_last_first() { clears_last_first_ = true; }
  /// Nobody else makes a set of files appear where these will (null: none), from now on until this goes: for who looks
  /// at what stands there before he decides what to add. commit() does it otherwise.
  void lock(const std::vector<const OutputFile*>& files);
  /// To be called once. Refuses with file-unwritable; then all is as it was, unless the message says what is not.
  void commit();

 private:
  // A place where a file has appeared, or was cleared, and what stood there before, under a passing name.
  struct Changed {
    std::string path;
    std::optional<PassingName> before;
    bool was_there = false;
  };
  void clear_last();
  bool appear(OutputFile& file);
  std::string take_back();

  std::vector<OutputFile*> files_;
  std::vector<Changed> changed_;
  std::vector<FolderLock> locks_;
  bool clears_last_first_ = false;
};

}  // namespace plumbline
