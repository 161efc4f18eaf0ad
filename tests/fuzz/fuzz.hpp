// What the fuzz targets share: the input as a file, the outcome "refused", and the check that stops a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include <unistd.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,  // NOLINT(readability-identifier-naming)
                                      std::size_t size);

/// What must hold of every input. Unlike an exception it is never taken for a refusal, and it stops libFuzzer.
#define FUZZ_CHECK(condition)                                                             \
  do {                                                                                    \
    if (!(condition)) {                                                                   \
      std::fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                       \
    }                                                                                     \
  } while (false)

namespace plumbline::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A folder in memory that goes with the process: what is read and written is not on a disk.
class Folder {
 public:
  Folder() {
    const bool shared = std::filesystem::is_directory("/dev/shm");
    std::string name =
        (shared ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path()) / "plumbline-fuzz-XXXXXX";
    const char* const made = mkdtemp(name.data());
    FUZZ_CHECK(made != nullptr);
    folder_ = made;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::string& path() const { return folder_; }
  std::string operator/(std::string_view name) const { return folder_ + "/" + std::string(name); }
  /// Writes a file in place, without OutputFile's care for disks; gives its path.
  std::string file(std::string_view name, std::string_view text) const {
    std::string path = *this / name;
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    FUZZ_CHECK(file != nullptr);
    FUZZ_CHECK(text.empty() || std::fwrite(text.data(), 1, text.size(), file) == text.size());
    FUZZ_CHECK(std::fclose(file) == 0);
    return path;
  }

 private:
  std::string folder_;
};

inline const Folder& folder() {
  static const Folder made;
  return made;
}

/// A refusal must say where and what to do, and be printable.
inline void check_diagnostic(const Diagnostic& diagnostic) {
  FUZZ_CHECK(!diagnostic.code.empty());
  FUZZ_CHECK(!diagnostic.message.empty());
  FUZZ_CHECK(!diagnostic.help.empty());
  FUZZ_CHECK(diagnostic.place.column <= diagnostic.place.text.size() + 1);
  FUZZ_CHECK(!to_text(diagnostic).empty());
}

/// True if `work` ends, false if it is refused. Anything else that it throws is a finding.
template <class Work>
bool is_taken(const Work& work) {
  try {
    work();
    return true;
  } catch (const Refusal& refusal) {
    check_diagnostic(refusal.diagnostic());
    return false;
  }
}

/// Two texts in one input, a line of "=====" between them; without one the second is empty.
struct Two {
  std::string_view first, second;
};
inline Two split(std::string_view input) {
  constexpr std::string_view kBetween = "=====\n";
  const std::size_t at = input.find(kBetween);
  if (at == std::string_view::npos) return {input, {}};
  return {input.substr(0, at), input.substr(at + kBetween.size())};
}

}  // namespace plumbline::fuzz
