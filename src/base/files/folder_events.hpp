// What the system tells of files that come, change and go.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/files/descriptor.hpp"
#include "base/platform/platform.hpp"

namespace plumbline {

struct FolderEvent {
  using Kind = platform::ChangeKind;
  Kind kind;
  std::string path;  // in a folder that is watched
};

/// Of Linux alone: elsewhere somebody has to look again and again.
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
