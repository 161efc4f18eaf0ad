#include "base/files/output_target.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostic.hpp"
#include "base/files/input_file.hpp"
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

std::string folder_of(const fs::path& path) {
  const std::string folder = path.parent_path().string();
  return folder.empty() ? "." : folder;
}

// Where Linux lists the open files of a process: /dev/stdout and /dev/fd/3 lead there.
bool lists_open_files(const fs::path& folder) {
  return folder.string().starts_with("/proc/") && folder.filename() == "fd";
}

// Follows links one by one, up to the list of open files of a process, a file, or a name that is still free.
fs::path follow(const std::string& name) {
  fs::path path = name;
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

// Only what the caller of this process left open for it: what it opens itself closes on exec.
OutputTarget open_file(const std::string& name, const std::string& number) {
  const std::optional<double> value = parse_number(number);
  const int descriptor = value && *value >= 0 && *value < 1e6 ? static_cast<int>(*value) : -1;
  const int flags = descriptor < 0 ? -1 : fcntl(descriptor, F_GETFD);
  const int access = flags < 0 || (flags & FD_CLOEXEC) != 0 ? -1 : fcntl(descriptor, F_GETFL);
  if (access < 0 || (access & O_ACCMODE) == O_RDONLY) {
    refuse_output("file-unwritable", name, access < 0 ? "is no open file" : "is open for reading alone",
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
  if (!is_read_only && faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0) return;
  refuse_output("file-unwritable", name,
                is_read_only ? "is read-only" : fmt::format("may not be written to: {}", std::strerror(errno)),
                "allow it with chmod u+w, or name another file for the output");
}

}  // namespace

std::string OutputTarget::folder() const { return folder_of(path); }

OutputTarget output_target(const std::string& name) {
  if (name == kStandardStream) return {OutputTarget::Kind::descriptor, name, STDOUT_FILENO, {}};
  const fs::path path = follow(name);
  const std::string own = fs::path("/proc/self/fd").string();
  std::error_code ignored;
  if (!path.parent_path().empty() && path.parent_path() == fs::canonical(own, ignored)) {
    return open_file(name, path.filename().string());
  }
  OutputTarget target;
  target.path = path.string();
  struct stat status {};
  if (stat(target.path.c_str(), &status) != 0) return target;
  if (S_ISDIR(status.st_mode)) refuse_output("file-is-folder", name, "is a folder, not a file", "name a file in it");
  if (!S_ISREG(status.st_mode) || lists_open_files(path.parent_path())) {
    target.kind = OutputTarget::Kind::device;
    return target;
  }
  refuse_read_only(name, target.path, status.st_mode);
  target.replaced = OutputTarget::Replaced{status.st_mode & 07777U, status.st_uid, status.st_gid};
  return target;
}

void adopt(int descriptor, const OutputTarget::Replaced& replaced) {
  unsigned mode = replaced.mode;
  if (fchown(descriptor, replaced.owner, replaced.group) != 0) {
    mode &= 0777U;
    if (fchown(descriptor, static_cast<uid_t>(-1), replaced.group) != 0) {
      mode = (mode & ~070U) | ((mode & 07U) << 3U);
    }
  }
  // Where this fails the file system has no permissions to keep.
  [[maybe_unused]] const int failed = fchmod(descriptor, mode);
}

}  // namespace plumbline
