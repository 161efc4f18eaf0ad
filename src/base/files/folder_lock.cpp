#include "base/files/folder_lock.hpp"

#include <cerrno>
#include <chrono>
#include <thread>

#include "base/diagnostic.hpp"

namespace plumbline {
namespace {

constexpr std::chrono::milliseconds kPause{2};
constexpr int kMostPauses = 60 * 1000 / 2;

}  // namespace

FolderLock::FolderLock(const std::string& folder, Kind kind) : folder_(platform::open_folder(folder)) {
  if (!folder_) return;  // it may be written to and not be read
  const platform::Lock lock = kind == Kind::shared ? platform::Lock::shared : platform::Lock::exclusive;
  for (int pauses = 0; !platform::try_lock(*folder_, lock); ++pauses) {
    if (errno != EWOULDBLOCK) return;
    if (pauses >= kMostPauses) {
      Place place;
      place.file = folder;
      refuse("file-unwritable", "the folder has been locked by another process for a minute",
             "end what holds it: another plumbline that was stopped, or a script that runs plumbline under flock",
             place);
    }
    std::this_thread::sleep_for(kPause);
  }
}

std::optional<FolderLock> FolderLock::try_lock(const std::string& folder) {
  platform::FolderHandle opened = platform::open_folder(folder);
  if (!opened || !platform::try_lock(*opened, platform::Lock::exclusive)) return std::nullopt;
  return FolderLock(std::move(opened));
}

bool FolderLock::sync() const { return !folder_ || platform::sync(*folder_); }

}  // namespace plumbline
