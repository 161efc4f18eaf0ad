#include "base/files.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 16U;
constexpr std::size_t kBufferedOutput = std::size_t{1} << 18U;

[[noreturn]] void refuse_file(std::string_view code, const std::string& path, std::string message, std::string help) {
  Place place;
  place.file = path;
  refuse(code, std::move(message), std::move(help), place);
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

int open_unnamed_temporary() {
  std::string name = (std::filesystem::temp_directory_path() / "plumbline-XXXXXX").string();
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) {
    refuse_file("file-unwritable", name, fmt::format("cannot make a temporary file: {}", std::strerror(errno)),
                "name a folder with room in the environment variable TMPDIR");
  }
  unlink(name.c_str());
  return descriptor;
}

bool write_all(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(descriptor, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

// Copies one open file to another, from where each stands to the end of the first.
bool copy_all(int from, int to) {
  std::vector<char> chunk(kChunk);
  while (true) {
    const ssize_t count = ::read(from, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    if (!write_all(to, chunk.data(), static_cast<std::size_t>(count))) return false;
  }
}

}  // namespace

InputFile::InputFile(const std::string& path) : name_(path) {
  if (path == kStandardStream) {
    name_ = "<stdin>";
    spool(STDIN_FILENO);
  } else {
    open(path);
  }
  struct stat status {};
  PLUMBLINE_CHECK(fstat(descriptor_, &status) == 0);
  size_ = static_cast<std::uint64_t>(status.st_size);
}

void InputFile::open(const std::string& path) {
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) {
    refuse_file(errno == ENOENT ? "file-missing" : "file-unreadable", path,
                fmt::format("cannot be opened: {}", std::strerror(errno)), "check the path and its permissions");
  }
  struct stat status {};
  PLUMBLINE_CHECK(fstat(descriptor_, &status) == 0);
  if (S_ISREG(status.st_mode)) return;
  const int opened = descriptor_;
  if (S_ISDIR(status.st_mode)) {
    ::close(opened);
    refuse_file("file-is-folder", path, "is a folder, not a file", "name a file in it");
  }
  spool(opened);
  ::close(opened);
}

// Pipes and devices cannot be sought in: what they give is kept in a temporary file.
void InputFile::spool(int from) {
  descriptor_ = open_unnamed_temporary();
  if (!copy_all(from, descriptor_)) {
    refuse_file("file-unreadable", name_, fmt::format("cannot be kept: {}", std::strerror(errno)),
                "write it into a file, and name that");
  }
}

InputFile::InputFile(InputFile&& other) noexcept
    : name_(std::move(other.name_)), descriptor_(other.descriptor_), size_(other.size_) {
  other.descriptor_ = -1;
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t InputFile::read(std::uint64_t offset, char* into, std::size_t count) const {
  std::size_t got = 0;
  while (got < count) {
    const ssize_t n = pread(descriptor_, into + got, count - got, static_cast<off_t>(offset + got));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      refuse_file("file-unreadable", name_, fmt::format("cannot be read: {}", std::strerror(errno)),
                  "check the disk that holds it");
    }
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  return got;
}

bool InputFile::is_same_as(const std::string& path) const {
  struct stat mine {};
  struct stat other {};
  return fstat(descriptor_, &mine) == 0 && ::stat(path.c_str(), &other) == 0 && mine.st_dev == other.st_dev &&
         mine.st_ino == other.st_ino;
}

std::string read_text(const std::string& path) {
  const InputFile file(path);
  std::string text(file.size(), '\0');
  text.resize(file.read(0, text.data(), text.size()));
  return text;
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path_, ignored)) {
    refuse_file("file-is-folder", path_, "is a folder, not a file", "name a file in it");
  }
  // A device or a pipe (/dev/null, /dev/stdout) is written to, never replaced.
  const bool is_special = std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored);
  if (path_ == kStandardStream || is_special) {
    descriptor_ = open_unnamed_temporary();
    return;
  }
  temporary_ = path_ + ".XXXXXX";
  descriptor_ = mkstemp(temporary_.data());
  if (descriptor_ < 0) {
    const int error = errno;
    temporary_.clear();
    refuse_write(error);
  }
  // mkstemp opens for the owner alone; the file that appears shall be like any other that the user makes.
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor_, 0666 & ~mask);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::refuse_write(int error) const {
  refuse_file("file-unwritable", path_, fmt::format("cannot be written: {}", std::strerror(error)),
              fmt::format("check that {} exists, may be written to and has room", folder_of(path_)));
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  size_ += bytes.size();
  if (hash_) hash_ = fnv1a(bytes, *hash_);
  if (buffer_.size() >= kBufferedOutput) flush();
}

void OutputFile::flush() {
  if (!write_all(descriptor_, buffer_.data(), buffer_.size())) refuse_write(errno);
  buffer_.clear();
}

void OutputFile::restart() {
  buffer_.clear();
  size_ = 0;
  if (hash_) hash_ = fnv1a({});
  if (ftruncate(descriptor_, 0) != 0 || lseek(descriptor_, 0, SEEK_SET) < 0) refuse_write(errno);
}

void OutputFile::commit() {
  PLUMBLINE_CHECK(descriptor_ >= 0);
  flush();
  if (temporary_.empty()) {
    copy_to_stream();
    return;
  }
  const bool closed = fsync(descriptor_) == 0 && ::close(descriptor_) == 0;
  descriptor_ = -1;
  if (!closed || rename(temporary_.c_str(), path_.c_str()) != 0) refuse_write(errno);
  temporary_.clear();
}

// What was spooled goes to standard output, or into the device or pipe that the path names.
void OutputFile::copy_to_stream() {
  const bool is_standard = path_ == kStandardStream;
  const int stream = is_standard ? STDOUT_FILENO : ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  if (stream < 0) refuse_write(errno);
  const bool copied = lseek(descriptor_, 0, SEEK_SET) == 0 && copy_all(descriptor_, stream);
  const int error = errno;
  const bool closed = is_standard || ::close(stream) == 0;
  ::close(descriptor_);
  descriptor_ = -1;
  if (!copied) refuse_write(error);
  if (!closed) refuse_write(errno);
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace plumbline
