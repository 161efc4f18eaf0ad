#include "base/files/file_state.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include <sys/stat.h>

#include "base/files/input_file.hpp"
#include "base/text/hash.hpp"

namespace plumbline {
namespace {

constexpr std::int64_t kNsPerS = 1'000'000'000;
constexpr std::size_t kHashedAtOnce = std::size_t{1} << 16U;

FileState state_of(const struct stat& status) {
  return {static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec * kNsPerS + status.st_mtim.tv_nsec,
          status.st_ino};
}

}  // namespace

std::optional<FileState> file_state(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return state_of(status);
}

std::optional<FileState> file_state(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return std::nullopt;
  return state_of(status);
}

std::optional<FileState> folder_state(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return std::nullopt;
  return state_of(status);
}

std::int64_t now_ns() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

std::uint64_t file_hash(const std::string& path) {
  const InputFile file(path);
  std::vector<char> chunk(static_cast<std::size_t>(std::min<std::uint64_t>(file.size() + 1, kHashedAtOnce)));
  std::uint64_t hash = fnv1a({});
  for (std::uint64_t at = 0;;) {
    const std::size_t got = file.read(at, chunk.data(), chunk.size());
    if (got == 0) return hash;
    hash = fnv1a({chunk.data(), got}, hash);
    at += got;
  }
}

}  // namespace plumbline
