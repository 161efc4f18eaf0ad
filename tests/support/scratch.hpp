// Files that a test writes, in a folder of its own that goes with it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

#include <unistd.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"

namespace plumbline::testing {

class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "plumbline-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::string path(std::string_view name) const { return (folder_ / name).string(); }
  std::string operator/(std::string_view name) const { return path(name); }
  /// Writes a file and gives its path.
  std::string file(std::string_view name, std::string_view text) const {
    write_text(path(name), text);
    return path(name);
  }
  bool has(std::string_view name) const { return std::filesystem::exists(path(name)); }
  std::string text(std::string_view name) const { return read_text(path(name)); }
  /// How many files and folders lie in it.
  std::size_t entries() const {
    const std::filesystem::directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

 private:
  std::filesystem::path folder_;
};

/// The diagnostic that `work` is refused with; its code is empty if it is not refused.
template <class Work>
Diagnostic refusal_of(const Work& work) {
  try {
    work();
  } catch (const Refusal& refusal) {
    return refusal.diagnostic();
  }
  return {};
}

inline std::string source_file(std::string_view name) { return PLUMBLINE_SOURCE_DIR "/" + std::string(name); }

}  // namespace plumbline::testing
