// What the system tells of files that come, change and go.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/files/descriptor.hpp"

namespace plumbline {

struct FolderEvent {
  enum class Kind {
    begun,     // a file is new, or is being written to
    finished,  // one that was written to is closed, or it came here whole under this name
    gone,
    folder,  // a folder is new
    lost,    // some events were: look at everything
  };
  Kind kind;
  std::string path;  // in a folder that is watched
};

/// Linux: inotify, which knows nothing of what other machines write into a folder that they share.
class FolderEvents {
 public:
  /// Nothing where there is no such thing, or no more of them may be had.
  static std::optional<FolderEvents> open();

  /// Watches a folder, without those in it. False: it cannot be, or no more can be.
  bool add(const std::string& folder);
  /// What has happened; empty when nothing did in that time.
  std::vector<FolderEvent> wait(std::chrono::milliseconds most);

 private:
  explicit FolderEvents(Descriptor queue) : queue_(std::move(queue)) {}

  Descriptor queue_;
  std::map<int, std::string> folders_;  // by the number of their watch
};

}  // namespace plumbline
