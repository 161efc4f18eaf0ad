#include "base/files/own_files.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/output_target.hpp"
#include "base/files/path_of.hpp"
#include "base/files/source.hpp"
#include "base/platform/platform.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

using platform::FileKind;

// Of what exists: /dev/null and terminals may be used twice.
std::optional<platform::FileStatus> status_of(const std::string& path, int standard_stream) {
  std::optional<platform::FileStatus> status =
      path == kStandardStream ? platform::status_of(standard_stream) : platform::status_of(path);
  if (status && status->kind != FileKind::file && status->kind != FileKind::pipe) status.reset();
  return status;
}

// A socket may be read from and written to: it holds two streams.
std::optional<platform::FileStatus> regular(std::optional<platform::FileStatus> status) {
  if (status && status->kind != FileKind::file) status.reset();
  return status;
}

bool is_same_file(const std::optional<platform::FileStatus>& a, const std::optional<platform::FileStatus>& b) {
  return a && b && platform::is_same_file(*a, *b);
}

// Of files that need not be there yet, and of standard output, whatever it is.
bool is_same_name(const std::string& a, const std::string& b) {
  if (a == b || (is_standard_output(a) && is_standard_output(b))) return true;
  if (a == kStandardStream || b == kStandardStream) return false;
  std::error_code unknown;
  const fs::path full_a = fs::weakly_canonical(fs::absolute(path_of(a), unknown), unknown);
  const fs::path full_b = fs::weakly_canonical(fs::absolute(path_of(b), unknown), unknown);
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
    const std::optional<platform::FileStatus> status = status_of(*output, platform::kStandardOutput);
    for (const std::string& input : inputs) {
      if (input.empty() || !is_same_file(regular(status), regular(status_of(input, platform::kStandardInput))))
        continue;
      refuse_output(
          "file-overwrites-input", *output,
          fmt::format("the output would overwrite the input {}", input == kStandardStream ? "<stdin>" : input));
    }
    for (auto other = outputs.begin(); other != output; ++other) {
      if (other->empty()) continue;
      if (!is_same_name(*other, *output) && !is_same_file(status, status_of(*other, platform::kStandardOutput)))
        continue;
      refuse_output("file-written-twice", *output, "two outputs would be written to the same file");
    }
  }
}

}  // namespace plumbline
