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
constexpr std::uint64_t kLargestText = 1'000'000'000;

[[noreturn]] void refuse_file(std::string_view code, const std::string& path, std::string message, std::string help) {
  Place place;
  place.file = path;
  refuse(code, std::move(message), std::move(help), place);
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

Descriptor open_unnamed_temporary() {
  std::error_code no_folder;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(no_folder);
  const char* const stated = std::getenv("TMPDIR");
  std::string name = no_folder && stated != nullptr ? stated : (folder / "plumbline-XXXXXX").string();
  Descriptor file(no_folder ? -1 : mkostemp(name.data(), O_CLOEXEC));
  if (!file.is_open()) {
    const std::string why = no_folder ? no_folder.message() : std::strerror(errno);
    refuse_file("file-unwritable", name, fmt::format("cannot make a temporary file: {}", why),
                "name a folder with room in the environment variable TMPDIR");
  }
  unlink(name.c_str());
  return file;
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

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) {
    close();
    number_ = other.release();
  }
  return *this;
}

Descriptor::~Descriptor() { close(); }

bool Descriptor::close() { return !is_open() || ::close(release()) == 0; }

InputFile::InputFile(const std::string& path) : name_(path) {
  if (path == kStandardStream) {
    name_ = "<stdin>";
    spool(STDIN_FILENO);
  } else {
    open(path);
  }
  struct stat status {};
  PLUMBLINE_CHECK(fstat(descriptor_.number(), &status) == 0);
  size_ = static_cast<std::uint64_t>(status.st_size);
}

void InputFile::open(const std::string& path) {
  Descriptor opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!opened.is_open()) {
    refuse_file(errno == ENOENT ? "file-missing" : "file-unreadable", path,
                fmt::format("cannot be opened: {}", std::strerror(errno)), "check the path and its permissions");
  }
  struct stat status {};
  PLUMBLINE_CHECK(fstat(opened.number(), &status) == 0);
  if (S_ISDIR(status.st_mode)) refuse_file("file-is-folder", path, "is a folder, not a file", "name a file in it");
  if (S_ISREG(status.st_mode)) {
    descriptor_ = std::move(opened);
  } else {
    spool(opened.number());
  }
}

// Pipes and devices cannot be sought in: what they give is kept in a temporary file.
void InputFile::spool(int from) {
  descriptor_ = open_unnamed_temporary();
  if (!copy_all(from, descriptor_.number())) {
    refuse_file("file-unreadable", name_, fmt::format("cannot be kept: {}", std::strerror(errno)),
                "write it into a file, and name that");
  }
}

std::size_t InputFile::read(std::uint64_t offset, char* into, std::size_t count) const {
  std::size_t got = 0;
  while (got < count) {
    const ssize_t n = pread(descriptor_.number(), into + got, count - got, static_cast<off_t>(offset + got));
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
  return fstat(descriptor_.number(), &mine) == 0 && ::stat(path.c_str(), &other) == 0 && mine.st_dev == other.st_dev &&
         mine.st_ino == other.st_ino;
}

std::string read_text(const std::string& path) {
  const InputFile file(path);
  if (file.size() > kLargestText) {
    refuse_file("file-too-large", file.name(),
                fmt::format("is {:.3g} GB large", static_cast<double>(file.size()) / 1e9),
                "name the right file, or cut it into several: no more than 1 GB is read at once");
  }
  std::string text(file.size(), '\0');
  text.resize(file.read(0, text.data(), text.size()));
  return text;
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
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
  const std::filesystem::path led_to = std::filesystem::canonical(path_, ignored);  // nothing for a file yet to be
  if (!led_to.empty()) target_ = led_to.string();
  temporary_ = target_ + ".XXXXXX";
  descriptor_ = Descriptor(mkostemp(temporary_.data(), O_CLOEXEC));
  if (!descriptor_.is_open()) {
    const int error = errno;
    temporary_.clear();
    refuse_write(error);
  }
  // mkostemp opens for the owner alone; the file that appears shall be like any other that the user makes.
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor_.number(), 0666 & ~mask);
}

OutputFile::~OutputFile() {
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
  if (!write_all(descriptor_.number(), buffer_.data(), buffer_.size())) refuse_write(errno);
  buffer_.clear();
}

void OutputFile::restart() {
  buffer_.clear();
  size_ = 0;
  if (hash_) hash_ = fnv1a({});
  if (ftruncate(descriptor_.number(), 0) != 0 || lseek(descriptor_.number(), 0, SEEK_SET) < 0) refuse_write(errno);
}

void OutputFile::commit() {
  PLUMBLINE_CHECK(descriptor_.is_open());
  flush();
  if (temporary_.empty()) {
    copy_to_stream();
    return;
  }
  const bool kept = fsync(descriptor_.number()) == 0 && descriptor_.close();
  if (!kept || rename(temporary_.c_str(), target_.c_str()) != 0) refuse_write(errno);
  temporary_.clear();
}

// What was spooled goes to standard output, or into the device or pipe that the path names.
void OutputFile::copy_to_stream() {
  Descriptor named;
  if (path_ != kStandardStream) {
    named = Descriptor(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
    if (!named.is_open()) refuse_write(errno);
  }
  const int stream = named.is_open() ? named.number() : STDOUT_FILENO;
  const bool copied = lseek(descriptor_.number(), 0, SEEK_SET) == 0 && copy_all(descriptor_.number(), stream);
  if (!copied || !named.close()) refuse_write(errno);
  descriptor_.close();
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace plumbline
