#include "base/files/input_file.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

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

platform::FileStatus state_of(int descriptor) {
  const std::optional<platform::FileStatus> status = platform::status_of(descriptor);
  PLUMBLINE_CHECK(status);
  return *status;
}

// A file that was not written to.
bool is_unchanged(const platform::FileStatus& before, const platform::FileStatus& now) {
  return platform::is_same_file(before, now) && before.size == now.size && before.changed_s == now.changed_s &&
         before.changed_ns == now.changed_ns;
}

}  // namespace

void refuse_endless_line(const std::string& path) {
  refuse_file(
      "file-endless-line", path,
      fmt::format("holds a line of more than {} million bytes, or one that does not end", kLongestLine / 1'000'000),
      "name a text of lines");
}

void PipedText::take(std::string_view chunk) {
  const std::size_t newline = chunk.rfind('\n');
  line_ = newline == std::string_view::npos ? line_ + chunk.size() : chunk.size() - newline - 1;
  all_ += chunk.size();
  if (line_ > kLongestLine) refuse_endless_line(name_);
  if (all_ > most_) {
    refuse_file("file-too-large", name_,
                fmt::format("gives more than {:.3g} GB, or has no end", static_cast<double>(most_) / 1e9),
                "a program of that size is read from a file: name it");
  }
}

InputFile::InputFile(const Source& source) : name_(source.name()), text_(source.text()) {
  if (text_) {
    size_ = text_->size();
    return;
  }
  if (source.is_standard_input()) {
    spool(platform::kStandardInput);
  } else {
    open(source.path());
  }
  state_ = state_of(descriptor_.number());
  size_ = state_.size;
}

void InputFile::open(const std::string& path) {
  Descriptor opened(platform::open_to_read(path));
  if (!opened.is_open()) {
    const int error = errno;
    refuse_file(error == ENOENT ? "file-missing" : "file-unreadable", path,
                fmt::format("cannot be opened: {}", std::strerror(error)),
                way_out(error, "check the path and its permissions"));
  }
  const platform::FileKind kind = state_of(opened.number()).kind;
  if (kind == platform::FileKind::folder)
    refuse_file("file-is-folder", path, "is a folder, not a file", "name a file in it");
  if (kind == platform::FileKind::file) {
    descriptor_ = std::move(opened);
  } else {
    spool(opened.number());
  }
}

// Pipes and devices cannot be sought in: what they give is kept in a temporary file.
void InputFile::spool(int from) {
  is_spooled_ = true;
  descriptor_ = open_unnamed_temporary();
  const std::optional<platform::FileStatus> before = platform::status_of(from);
  if (!before) refuse_file("file-unreadable", name_, std::strerror(errno), "check the redirection");
  PipedText piped(name_);
  if (!copy_all(from, descriptor_.number(), [&](std::string_view chunk) { piped.take(chunk); })) {
    if (errno == EBADF) {
      refuse_file("file-unreadable", name_, "is closed: there is nothing to read",
                  "give it by < or a pipe, or name its file");
    }
    refuse_file("file-unreadable", name_, fmt::format("cannot be kept: {}", std::strerror(errno)),
                "write it into a file, and name that");
  }
  if (before->kind == platform::FileKind::file && !is_unchanged(*before, state_of(from))) refuse_changed();
}

std::size_t InputFile::read(std::uint64_t offset, char* into, std::size_t count) const {
  if (text_) return offset < text_->size() ? text_->copy(into, count, offset) : 0;
  std::size_t got = 0;
  while (got < count) {
    const std::ptrdiff_t n = platform::read_at(descriptor_.number(), into + got, count - got, offset + got);
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
  const std::optional<platform::FileStatus> other = text_ ? std::nullopt : platform::status_of(path);
  return other && platform::is_same_file(state_, *other);
}

void InputFile::check_unchanged() const {
  if (is_spooled_ || text_) return;
  if (!is_unchanged(state_, state_of(descriptor_.number())) || !is_same_as(name_)) refuse_changed();
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
