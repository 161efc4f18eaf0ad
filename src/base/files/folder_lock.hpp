// One at a time where files of several names appear together.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/platform/platform.hpp"

namespace plumbline {

/// A folder locked for all that take this lock; no file is made. Given back when this goes, or when the process ends.
class FolderLock {
 public:
  enum class Kind { shared, exclusive };

  /// Waits for it, a minute at most: then it refuses with file-unwritable. Where the file system has no such locks it
  /// is none.
  FolderLock(const std::string& folder, Kind kind);
  /// Nothing if another has it, or there are no locks here.
  static std::optional<FolderLock> try_lock(const std::string& folder);

  /// Makes sure that names given in the folder last; false with errno if they may not.
  bool sync() const;

 private:
  explicit FolderLock(platform::FolderHandle folder) : folder_(std::move(folder)) {}
  platform::FolderHandle folder_;
};

}  // namespace plumbline
