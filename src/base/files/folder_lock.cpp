#include "base/files/folder_lock.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/diagnostic.hpp"

namespace plumbline {
namespace {

constexpr useconds_t kPause_us = 2000;
constexpr int kMostPauses = 60 * 1000 / 2;

Descriptor open_folder(const std::string& folder) {
  return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

}  // namespace

FolderLock::FolderLock(const std::string& folder, Kind kind) : folder_(open_folder(folder)) {
  if (!folder_.is_open()) return;  // it may be written to and not be read
  const int operation = (kind == Kind::shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
  for (int pauses = 0; flock(folder_.number(), operation) != 0; ++pauses) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;
    if (pauses >= kMostPauses) {
      Place place;
      place.file = folder;
      refuse("file-unwritable", "the folder has been locked by another process for a minute",
             "end what holds it: another plumbline that was stopped, or a script that runs plumbline under flock",
             place);
    }
    usleep(kPause_us);
  }
}

std::optional<FolderLock> FolderLock::try_lock(const std::string& folder) {
  Descriptor opened = open_folder(folder);
  if (!opened.is_open() || flock(opened.number(), LOCK_EX | LOCK_NB) != 0) return std::nullopt;
  return FolderLock(std::move(opened));
}

bool FolderLock::sync() const {
  if (!folder_.is_open() || fsync(folder_.number()) == 0) return true;
  return errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;  // a file system that has nothing to sync here
}

}  // namespace plumbline
