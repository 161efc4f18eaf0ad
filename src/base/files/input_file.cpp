#include "base/files/input_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/files/temporary_file.hpp"

namespace plumbline {
namespace {

constexpr std::uint64_t kLargestText = 1'000'000'000;

[[noreturn]] void refuse_file(std::string_view code, const std::string& path, std::string message, std::string help) {
  Place place;
  place.file = path;
  refuse(code, std::move(message), std::move(help), place);
}

}  // namespace

InputFile::InputFile(const Source& source) : name_(source.name()), text_(source.text()) {
  if (text_) {
    size_ = text_->size();
    return;
  }
  if (source.is_standard_input()) {
    spool(STDIN_FILENO);
  } else {
    open(source.path());
  }
  state_ = state_of(descriptor_.number());
  size_ = state_.size;
}

InputFile::State InputFile::state_of(int descriptor) {
  struct stat status {};
  PLUMBLINE_CHECK(fstat(descriptor, &status) == 0);
  return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
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
  is_spooled_ = true;
  descriptor_ = open_unnamed_temporary();
  struct stat status {};
  if (fstat(from, &status) != 0) refuse_file("file-unreadable", name_, std::strerror(errno), "check the redirection");
  const State before = state_of(from);
  if (!copy_all(from, descriptor_.number())) {
    refuse_file("file-unreadable", name_, fmt::format("cannot be kept: {}", std::strerror(errno)),
                "write it into a file, and name that");
  }
  if (S_ISREG(status.st_mode) && state_of(from) != before) refuse_changed();
}

std::size_t InputFile::read(std::uint64_t offset, char* into, std::size_t count) const {
  if (text_) return offset < text_->size() ? text_->copy(into, count, offset) : 0;
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
  struct stat other {};
  return !text_ && ::stat(path.c_str(), &other) == 0 && state_.device == other.st_dev && state_.number == other.st_ino;
}

void InputFile::check_unchanged() const {
  if (is_spooled_ || text_) return;
  if (state_of(descriptor_.number()) != state_ || !is_same_as(name_)) refuse_changed();
}

void InputFile::refuse_changed() const {
  refuse_file("file-changed", name_, "was written to, cut or replaced while it was read",
              "wait until whatever writes it is done, and try again");
}

std::string read_text(const Source& source) {
  if (source.is_held()) return *source.text();
  const InputFile file(source);
  if (file.size() > kLargestText) {
    refuse_file("file-too-large", file.name(),
                fmt::format("is {:.3g} GB large", static_cast<double>(file.size()) / 1e9),
                "name the right file, or cut it into several: no more than 1 GB is read at once");
  }
  std::string text(file.size(), '\0');
  text.resize(file.read(0, text.data(), text.size()));
  file.check_unchanged();
  return text;
}

}  // namespace plumbline
