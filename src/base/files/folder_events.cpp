#include "base/files/folder_events.hpp"

#include <filesystem>
#include <utility>

#include "base/files/path_of.hpp"

namespace plumbline {

std::optional<FolderEvents> FolderEvents::open() {
  Descriptor queue(platform::open_changes());
  if (!queue.is_open()) return std::nullopt;
  return FolderEvents(std::move(queue));
}

bool FolderEvents::add(const std::string& folder) {
  const int watch = platform::watch_folder(queue_.number(), folder);
  if (watch >= 0) folders_[watch] = folder;
  return watch >= 0;
}

std::vector<FolderEvent> FolderEvents::wait(std::chrono::milliseconds most) {
  std::vector<FolderEvent> events;
  for (const platform::Change& change : platform::wait_for_changes(queue_.number(), static_cast<int>(most.count()))) {
    const std::string folder = change.kind == FolderEvent::Kind::lost ? "" : folders_[change.watch];
    events.push_back(
        {change.kind, change.name.empty() ? folder : (path_of(folder) / path_of(change.name)).generic_string()});
  }
  return events;
}

}  // namespace plumbline
