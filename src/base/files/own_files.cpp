#include "base/files/own_files.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

struct Identity {
  dev_t device;
  ino_t number;
  bool operator==(const Identity&) const = default;
};

// Of a regular file that exists: pipes and terminals may be used twice.
std::optional<Identity> identity_of(const std::string& path, int standard_stream) {
  struct stat status {};
  const int failed = path == kStandardStream ? fstat(standard_stream, &status) : stat(path.c_str(), &status);
  if (failed != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return Identity{status.st_dev, status.st_ino};
}

// Of files that need not be there yet.
bool is_same_name(const std::string& a, const std::string& b) {
  if (a == b) return true;
  if (a == kStandardStream || b == kStandardStream) return false;
  std::error_code unknown;
  const fs::path full_a = fs::weakly_canonical(fs::absolute(a, unknown), unknown);
  const fs::path full_b = fs::weakly_canonical(fs::absolute(b, unknown), unknown);
  return !full_a.empty() && full_a == full_b;
}

[[noreturn]] void refuse_output(std::string_view code, const std::string& output, std::string message) {
  Place place;
  place.file = output == kStandardStream ? "<stdout>" : output;
  refuse(code, std::move(message), "name another file for the output", place);
}

}  // namespace

void refuse_shared_files(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->empty()) continue;
    const std::optional<Identity> identity = identity_of(*output, STDOUT_FILENO);
    for (const std::string& input : inputs) {
      if (input.empty() || !identity || identity != identity_of(input, STDIN_FILENO)) continue;
      refuse_output(
          "file-overwrites-input", *output,
          fmt::format("the output would overwrite the input {}", input == kStandardStream ? "<stdin>" : input));
    }
    for (auto other = outputs.begin(); other != output; ++other) {
      if (other->empty()) continue;
      if (!is_same_name(*other, *output) && !(identity && identity == identity_of(*other, STDOUT_FILENO))) continue;
      refuse_output("file-written-twice", *output, "two outputs would be written to the same file");
    }
  }
}

}  // namespace plumbline
