#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/platform/platform.hpp"

namespace plumbline::platform {
namespace {

FileStatus status_in(const struct stat& status) {
  FileStatus result;
  const auto is_pipe = S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode);
  result.kind = S_ISREG(status.st_mode)   ? FileKind::file
                : S_ISDIR(status.st_mode) ? FileKind::folder
                : is_pipe                 ? FileKind::pipe
                                          : FileKind::other;
  result.device = status.st_dev;
  result.number = status.st_ino;
  result.size = static_cast<std::uint64_t>(status.st_size);
  result.changed_s = status.st_mtim.tv_sec;
  result.changed_ns = status.st_mtim.tv_nsec;
  result.mode = status.st_mode & 07777U;
  result.owner = status.st_uid;
  result.group = status.st_gid;
  return result;
}

bool is_still_named(int descriptor, const std::string& path) {
  struct stat open {};
  struct stat named {};
  return fstat(descriptor, &open) == 0 && lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

// Again where a signal came in between.
template <class Call>
auto whole(Call call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

constexpr std::array kEndingSignals{SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ};

}  // namespace

const char* const kAllowWriting = "chmod u+w";

std::optional<FileStatus> status_of(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return std::nullopt;
  return status_in(status);
}

std::optional<FileStatus> status_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return status_in(status);
}

int open_to_read(const std::string& path) { return open(path.c_str(), O_RDONLY | O_CLOEXEC); }

int open_to_append(const std::string& path) { return open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC); }

int make_held_file(const std::string& path, unsigned mode) {
  const int made = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, mode);
  if (made < 0) {
    if (errno == EEXIST || errno == EINTR) errno = EAGAIN;
    return -1;
  }
  // Who sweeps may have had the lock first, and removed it.
  whole([made] { return flock(made, LOCK_EX); });
  if (is_still_named(made, path)) return made;
  close(made);
  errno = EAGAIN;
  return -1;
}

int make_unnamed_file(const std::string& folder) { return open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0600); }

// Whoever holds its lock is alive. Where there are no locks, nothing is swept.
void remove_if_left(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return;
  struct stat status {};
  if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && flock(file, LOCK_EX | LOCK_NB) == 0 &&
      is_still_named(file, path)) {
    unlink(path.c_str());
  }
  close(file);
}

std::ptrdiff_t read(int descriptor, char* into, std::size_t count) {
  return whole([=] { return ::read(descriptor, into, count); });
}

std::ptrdiff_t write(int descriptor, const char* bytes, std::size_t count) {
  return whole([=] { return ::write(descriptor, bytes, count); });
}

std::ptrdiff_t read_at(int descriptor, char* into, std::size_t count, std::uint64_t offset) {
  return whole([=] { return pread(descriptor, into, count, static_cast<off_t>(offset)); });
}

std::ptrdiff_t append(int descriptor, const char* bytes, std::size_t count) { return write(descriptor, bytes, count); }

bool rewind(int descriptor) { return lseek(descriptor, 0, SEEK_SET) == 0; }

bool empty(int descriptor) { return ftruncate(descriptor, 0) == 0 && rewind(descriptor); }

bool sync(int descriptor) { return fsync(descriptor) == 0; }

bool close(int descriptor) { return ::close(descriptor) == 0; }

bool rename(const std::string& from, const std::string& to) { return ::rename(from.c_str(), to.c_str()) == 0; }

bool link(const std::string& path, const std::string& name) { return ::link(path.c_str(), name.c_str()) == 0; }

bool remove_file(const std::string& path) { return unlink(path.c_str()) == 0; }

// Of signals' handlers, too: system calls alone.
bool remove_name(const char* path) { return unlink(path) == 0 || (errno == EISDIR && rmdir(path) == 0); }

bool may_write(const std::string& path) { return faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0; }

// Where the group cannot be kept, it is allowed no more than others are.
void adopt(int descriptor, const FileStatus& replaced) {
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

// What this process opens itself closes on exec.
LeftOpen left_open(int descriptor) {
  const int flags = descriptor < 0 ? -1 : fcntl(descriptor, F_GETFD);
  const int access = flags < 0 || (flags & FD_CLOEXEC) != 0 ? -1 : fcntl(descriptor, F_GETFL);
  if (access < 0) return LeftOpen::no;
  return (access & O_ACCMODE) == O_RDONLY ? LeftOpen::for_reading : LeftOpen::for_writing;
}

class OpenFolder {
 public:
  explicit OpenFolder(int descriptor) : descriptor_(descriptor) {}
  OpenFolder(OpenFolder&&) = delete;
  OpenFolder& operator=(OpenFolder&&) = delete;
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;
  ~OpenFolder() { close(descriptor_); }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

void CloseFolder::operator()(OpenFolder* folder) const { delete folder; }

FolderHandle open_folder(const std::string& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return FolderHandle(descriptor < 0 ? nullptr : new OpenFolder(descriptor));
}

bool try_lock(OpenFolder& folder, Lock kind) {
  const int operation = (kind == Lock::shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
  return whole([&] { return flock(folder.descriptor(), operation); }) == 0;
}

bool sync(const OpenFolder& folder) {
  if (fsync(folder.descriptor()) == 0) return true;
  return errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;  // a file system that has nothing to sync here
}

// A shell can start a program with a stream closed (2>&-): messages would go into the file that takes its place.
void prepare_standard_streams() {
  for (const int stream : {kStandardInput, kStandardOutput, kStandardError}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    open("/dev/null", stream == kStandardError ? O_RDWR : stream == kStandardInput ? O_WRONLY : O_RDONLY);
  }
}

unsigned processors() {
#ifdef __linux__
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
    return std::max(1U, static_cast<unsigned>(CPU_COUNT(&allowed)));
  }
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

std::vector<std::string> arguments_of(int count, const char* const* arguments) {
  return {arguments, arguments + count};
}

std::optional<std::string> environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

std::string settings_folder() {
  const std::string stated = environment("XDG_CONFIG_HOME").value_or("");
  const std::string home = environment("HOME").value_or("");
  return stated.empty() && !home.empty() ? home + "/.config" : stated;
}

bool is_terminal(int descriptor) { return isatty(descriptor) == 1; }

std::size_t terminal_columns(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

bool shows_colours(int /*descriptor*/) {
  const std::optional<std::string> terminal = environment("TERM");
  return terminal && *terminal != "dumb";
}

void call_at_end(void (*end)(int signal)) {
  struct sigaction action {};
  action.sa_handler = end;
  for (const int signal : kEndingSignals) sigaddset(&action.sa_mask, signal);
  for (const int signal : kEndingSignals) {
    struct sigaction was {};
    if (sigaction(signal, nullptr, &was) == 0 && was.sa_handler == SIG_DFL) sigaction(signal, &action, nullptr);
  }
}

void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  sigset_t this_one;
  sigemptyset(&this_one);
  sigaddset(&this_one, signal);
  pthread_sigmask(SIG_UNBLOCK, &this_one, nullptr);
  raise(signal);
  _exit(128 + signal);
}

void wait_for_end() { pause(); }

}  // namespace plumbline::platform
