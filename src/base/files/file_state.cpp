#include "base/files/file_state.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <vector>

#include "base/files/input_file.hpp"
#include "base/platform/platform.hpp"
#include "base/text/hash.hpp"

namespace plumbline {
namespace {

constexpr std::int64_t kNsPerS = 1'000'000'000;
constexpr std::size_t kHashedAtOnce = std::size_t{1} << 16U;

std::optional<FileState> state_if(const std::optional<platform::FileStatus>& status, platform::FileKind kind) {
  if (!status || status->kind != kind) return std::nullopt;
  return FileState{status->size, status->changed_s * kNsPerS + status->changed_ns, status->number};
}

}  // namespace

std::optional<FileState> file_state(const std::string& path) {
  return state_if(platform::status_of(path), platform::FileKind::file);
}

std::optional<FileState> file_state(int descriptor) {
  return state_if(platform::status_of(descriptor), platform::FileKind::file);
}

std::optional<FileState> folder_state(const std::string& path) {
  return state_if(platform::status_of(path), platform::FileKind::folder);
}

std::string_view what_stands(const std::filesystem::path& path) {
  std::error_code none;
  switch (std::filesystem::status(path, none).type()) {
    case std::filesystem::file_type::regular:
      return "a file";
    case std::filesystem::file_type::directory:
      return "a folder";
    case std::filesystem::file_type::fifo:
      return "a pipe";
    case std::filesystem::file_type::socket:
      return "a socket";
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::character:
      return "a device";
    default:
      return std::filesystem::is_symlink(path, none) ? "a link that leads to no file" : "no file";
  }
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
