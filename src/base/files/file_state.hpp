// What stands at a path; what tells that a file has changed, without reading it; and its fingerprint.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline {

struct FileState {
  std::uint64_t size = 0;
  std::int64_t changed_ns = 0;  // when it was last written to, since 1970
  std::uint64_t number = 0;     // of the file in its file system: another one that takes its name has another
  bool operator==(const FileState&) const = default;
};

/// Of a regular file, links followed; nothing if there is none.
std::optional<FileState> file_state(const std::string& path);
/// Of an open one.
std::optional<FileState> file_state(int descriptor);
/// Of a folder: it changes when a file in it is made, renamed or removed. Nothing if there is none.
std::optional<FileState> folder_state(const std::string& path);

/// What stands at a path where a file is wanted, links followed, to be said behind "is": a folder, a pipe.
std::string_view what_stands(const std::filesystem::path& path);

/// Now, on the clock of FileState.
std::int64_t now_ns();

/// The fnv1a of what the file holds. Refuses as InputFile does.
std::uint64_t file_hash(const std::string& path);

}  // namespace plumbline
