#include "base/files/temporary_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/folder_lock.hpp"
#include "base/files/path_of.hpp"
#include "base/platform/platform.hpp"

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

}  // namespace

std::string passing_name_in(const std::string& folder) {
  static thread_local std::random_device source;
  const std::uint64_t number = (std::uint64_t{source()} << 32U) | source();
  return (path_of(folder) / fmt::format("{}{:016x}{}", kBegin, number, kEnd)).generic_string();
}

std::optional<TemporaryFile> make_temporary_file(const std::string& folder, unsigned mode) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    TemporaryFile made{PassingName(passing_name_in(folder)), {}};
    made.descriptor = Descriptor(platform::make_held_file(made.name.path(), mode));
    if (made.descriptor.is_open()) return made;
    const int error = errno;
    made.name.let_go();
    errno = error;
    if (error != EAGAIN) return std::nullopt;
  }
  return std::nullopt;
}

void sweep_temporary_files(const std::string& folder) {
  std::error_code ignored;
  for (fs::directory_iterator entry(path_of(folder), ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    if (!is_passing_name(entry->path().filename().generic_string())) continue;
    // What a set of outputs replaces waits under such a name, too, with the folder locked.
    const std::optional<FolderLock> lock = FolderLock::try_lock(folder);
    if (lock) platform::remove_if_left(entry->path().generic_string());
  }
}

Descriptor open_unnamed_temporary() {
  std::error_code no_folder;
  const fs::path folder = fs::temp_directory_path(no_folder);
  if (!no_folder) {
    Descriptor file(platform::make_unnamed_file(folder.generic_string()));
    if (file.is_open()) return file;
    if (auto made = make_temporary_file(folder.generic_string(), 0600)) return std::move(made->descriptor);
  }
  const int error = errno;
  const std::optional<std::string> stated = platform::environment("TMPDIR");
  Place place;
  place.file = no_folder && stated ? *stated : folder.generic_string();
  refuse("file-unwritable",
         fmt::format("cannot make a temporary file: {}", no_folder ? no_folder.message() : std::strerror(error)),
         way_out(no_folder ? 0 : error, "name a folder with room in the environment variable TMPDIR"), place);
}

}  // namespace plumbline
