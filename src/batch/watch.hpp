// A folder whose programs are compensated as they come.
#pragma once

#include <functional>
#include <string>

#include "batch/batch.hpp"
#include "batch/folder_watch.hpp"

namespace plumbline::batch {

struct Watcher {
  std::function<void(const jobs::BatchItem&)>
      item;                                  // as of Observer; one that was refused in the same words is not told again
  std::function<void(const Result&)> round;  // each time the folder has been gone through
  std::function<bool()> goes_on;             // asked every second or so; empty: for ever
  std::function<void(const Diagnostic&)> warning;  // of the folder itself
};

/// Goes through the folder, and again each time a program, or a file that programs are made with, has changed. A folder
/// that goes is waited for. Refuses as run() does.
void watch(const Request& request, const FolderWatch::Settings& settings, const Watcher& watcher);

}  // namespace plumbline::batch
