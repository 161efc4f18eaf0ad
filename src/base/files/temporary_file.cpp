#include "base/files/temporary_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostic.hpp"
#include "base/files/folder_lock.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = ".plumbline-";
constexpr std::string_view kEnd = ".tmp";
constexpr std::size_t kDigits = 16;
constexpr int kAttempts = 100;

bool is_passing_name(std::string_view name) {
  if (name.size() != kBegin.size() + kDigits + kEnd.size() || !name.starts_with(kBegin) || !name.ends_with(kEnd)) {
    return false;
  }
  return name.find_first_not_of("0123456789abcdef", kBegin.size()) == kBegin.size() + kDigits;
}

bool is_still_named(int descriptor, const std::string& path) {
  struct stat open {};
  struct stat named {};
  return fstat(descriptor, &open) == 0 && lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

// Whoever holds its lock is alive. Where there are no locks, nothing is swept.
void remove_if_left(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat status {};
  if (!file.is_open() || fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) return;
  if (flock(file.number(), LOCK_EX | LOCK_NB) != 0 || !is_still_named(file.number(), path)) return;
  unlink(path.c_str());
}

}  // namespace

std::string passing_name_in(const std::string& folder) {
  static thread_local std::random_device source;
  const std::uint64_t number = (std::uint64_t{source()} << 32U) | source();
  return (fs::path(folder) / fmt::format("{}{:016x}{}", kBegin, number, kEnd)).string();
}

std::optional<TemporaryFile> make_temporary_file(const std::string& folder, unsigned mode) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    TemporaryFile made{PassingName(passing_name_in(folder)), {}};
    const std::string& path = made.name.path();
    made.descriptor = Descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode));
    if (!made.descriptor.is_open()) {
      const int error = errno;
      made.name.let_go();
      errno = error;
      if (error == EEXIST || error == EINTR) continue;
      return std::nullopt;
    }
    // Who sweeps may have had the lock first, and removed it.
    while (flock(made.descriptor.number(), LOCK_EX) != 0 && errno == EINTR) {
    }
    if (is_still_named(made.descriptor.number(), path)) return made;
  }
  return std::nullopt;
}

void sweep_temporary_files(const std::string& folder) {
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    if (!is_passing_name(entry->path().filename().string())) continue;
    // What a set of outputs replaces waits under such a name, too, with the folder locked.
    const std::optional<FolderLock> lock = FolderLock::try_lock(folder);
    if (lock) remove_if_left(entry->path().string());
  }
}

Descriptor open_unnamed_temporary() {
  std::error_code no_folder;
  const fs::path folder = fs::temp_directory_path(no_folder);
  if (!no_folder) {
    Descriptor file(::open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0600));
    if (file.is_open()) return file;
    if (auto made = make_temporary_file(folder.string(), 0600)) return std::move(made->descriptor);
  }
  const char* const stated = std::getenv("TMPDIR");
  Place place;
  place.file = no_folder && stated != nullptr ? stated : folder.string();
  refuse("file-unwritable",
         fmt::format("cannot make a temporary file: {}", no_folder ? no_folder.message() : std::strerror(errno)),
         "name a folder with room in the environment variable TMPDIR", place);
}

}  // namespace plumbline
