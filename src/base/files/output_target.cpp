#include "base/files/output_target.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/input_file.hpp"
#include "base/files/path_of.hpp"
#include "base/platform/platform.hpp"
#include "base/text/number_text.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as Linux
constexpr unsigned kAnyoneWrites = 0222;

[[noreturn]] void refuse_output(std::string_view code, const std::string& name, std::string message, std::string help) {
  Place place;
  place.file = name;
  refuse(code, std::move(message), std::move(help), place);
}

fs::path folder_of(const fs::path& path) {
  fs::path folder = path.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

// Where Linux lists the open files of a process: /dev/stdout and /dev/fd/3 lead there.
bool lists_open_files(const fs::path& folder) {
  return folder.generic_string().starts_with("/proc/") && folder.filename() == "fd";
}

// Follows links one by one, up to the list of open files of a process, a file, or a name that is still free.
fs::path follow(const std::string& name) {
  fs::path path = path_of(name);
  for (int links = 0; links < kMostLinks; ++links) {
    std::error_code ignored;
    const fs::path folder = fs::canonical(folder_of(path), ignored);
    if (!folder.empty() && lists_open_files(folder)) return folder / path.filename();
    const fs::path link = fs::read_symlink(path, ignored);
    if (link.empty()) return path;
    path = path.parent_path() / link;
  }
  refuse_output("file-unwritable", name, "leads from link to link without an end", "name the file itself");
}

// Only what the caller of this process left open for it.
OutputTarget open_file(const std::string& name, const std::string& number) {
  const std::optional<double> value = parse_number(number);
  const int descriptor = value && *value >= 0 && *value < 1e6 ? static_cast<int>(*value) : -1;
  const platform::LeftOpen left = platform::left_open(descriptor);
  if (left != platform::LeftOpen::for_writing) {
    refuse_output("file-unwritable", name,
                  left == platform::LeftOpen::no ? "is no open file" : "is open for reading alone",
                  "open it for the command, as in 3>out.ngc, or name a file");
  }
  OutputTarget target;
  target.kind = OutputTarget::Kind::descriptor;
  target.path = name;
  target.descriptor = descriptor;
  return target;
}

void refuse_read_only(const std::string& name, const std::string& path, unsigned mode) {
  const bool is_read_only = (mode & kAnyoneWrites) == 0;  // the superuser, too, meant that
  if (!is_read_only && platform::may_write(path)) return;
  refuse_output("file-unwritable", name,
                is_read_only ? "is read-only" : fmt::format("may not be written to: {}", std::strerror(errno)),
                fmt::format("allow it with {}, or name another file for the output", platform::kAllowWriting));
}

}  // namespace

std::string OutputTarget::folder() const { return folder_of(path_of(path)).generic_string(); }

OutputTarget output_target(const std::string& name) {
  if (name == kStandardStream) return {OutputTarget::Kind::descriptor, name, platform::kStandardOutput, {}};
  const fs::path path = follow(name);
  const std::string own = fs::path("/proc/self/fd").generic_string();
  std::error_code ignored;
  if (!path.parent_path().empty() && path.parent_path() == fs::canonical(own, ignored)) {
    return open_file(name, path.filename().generic_string());
  }
  OutputTarget target;
  target.path = path.generic_string();
  const std::optional<platform::FileStatus> status = platform::status_of(target.path);
  if (!status) return target;
  if (status->kind == platform::FileKind::folder)
    refuse_output("file-is-folder", name, "is a folder, not a file", "name a file in it");
  if (status->kind != platform::FileKind::file || lists_open_files(path.parent_path())) {
    target.kind = OutputTarget::Kind::device;
    return target;
  }
  refuse_read_only(name, target.path, status->mode);
  target.replaced = status;
  return target;
}

bool is_standard_output(const std::string& name) try {
  if (name.empty()) return false;
  const OutputTarget target = output_target(name);
  if (target.kind != OutputTarget::Kind::descriptor) return false;
  if (target.descriptor == platform::kStandardOutput) return true;
  const std::optional<platform::FileStatus> one = platform::status_of(target.descriptor);
  const std::optional<platform::FileStatus> other = platform::status_of(platform::kStandardOutput);
  return one && other && one->kind == platform::FileKind::pipe && platform::is_same_file(*one, *other);
} catch (const Refusal&) {
  return false;  // whoever opens it says why
}

}  // namespace plumbline
