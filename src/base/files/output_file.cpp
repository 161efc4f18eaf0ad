#include "base/files/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/files/output_set.hpp"
#include "base/platform/platform.hpp"

namespace plumbline {
namespace {

constexpr unsigned kUsualMode = 0666;  // what the umask lets through of it

OutputTarget taken_target(const std::string& name) {
  OutputTarget target;
  target.kind = OutputTarget::Kind::taker;
  target.path = name;
  return target;
}

}  // namespace

OutputFile::OutputFile(const Destination& to)
    : path_(to.name()), take_(to.taker()), target_(take_ ? taken_target(path_) : output_target(path_)) {
  if (target_.kind != OutputTarget::Kind::file) {
    descriptor_ = open_unnamed_temporary();
    return;
  }
  sweep_temporary_files(target_.folder());
  const unsigned mode = target_.replaced ? target_.replaced->mode & kUsualMode : kUsualMode;
  std::optional<TemporaryFile> made = make_temporary_file(target_.folder(), mode);
  if (!made) refuse_write(errno);
  temporary_ = std::move(made->name);
  descriptor_ = std::move(made->descriptor);
}

void OutputFile::refuse_write(int error, std::string_view also) const {
  Place place;
  place.file = path_;
  refuse("file-unwritable", fmt::format("cannot be written: {}{}", std::strerror(error), also),
         way_out(error, fmt::format("check that {} exists, may be written to and has room",
                                    target_.kind == OutputTarget::Kind::file ? target_.folder() : path_)),
         place);
}

void OutputFile::flush() {
  for (std::size_t put = 0; put < buffer_.size();) {
    const std::ptrdiff_t n = platform::append(descriptor_.number(), buffer_.data() + put, buffer_.size() - put);
    if (n <= 0) refuse_write(errno);
    put += static_cast<std::size_t>(n);
  }
  if (hash_) hash_ = fnv1a(buffer_, *hash_);
  buffer_.clear();
}

void OutputFile::copy_to(OutputFile& other) {
  flush();
  std::vector<char> chunk(kBuffered);
  for (std::uint64_t at = 0;;) {
    const std::size_t got = read(at, chunk.data(), chunk.size());
    if (got == 0) return;
    other.write({chunk.data(), got});
    at += got;
  }
}

std::size_t OutputFile::read(std::uint64_t offset, char* into, std::size_t count) const {
  std::size_t got = 0;
  while (got < count) {
    const std::ptrdiff_t n = platform::read_at(descriptor_.number(), into + got, count - got, offset + got);
    if (n < 0) refuse_write(errno);
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  return got;
}

void OutputFile::restart() {
  buffer_.clear();
  size_ = 0;
  if (hash_) hash_ = fnv1a({});
  if (!platform::empty(descriptor_.number())) refuse_write(errno);
}

void OutputFile::commit() {
  OutputSet alone;
  alone.add(*this);
  alone.commit();
}

// All of it lasts, still under its passing name.
void OutputFile::finish() {
  PLUMBLINE_CHECK(descriptor_.is_open());
  flush();
  if (!temporary_) return;
  if (target_.replaced) platform::adopt(descriptor_.number(), *target_.replaced);
  if (!platform::sync(descriptor_.number())) refuse_write(errno);
}

// What was spooled goes to an open file, or into the device or pipe that the path names.
void OutputFile::send() {
  if (take_) return hand_over();
  Descriptor named;
  if (target_.kind == OutputTarget::Kind::device) {
    named = Descriptor(platform::open_to_append(target_.path));
    if (!named.is_open()) refuse_write(errno);
  }
  const int stream = named.is_open() ? named.number() : target_.descriptor;
  const bool copied = platform::rewind(descriptor_.number()) && copy_all(descriptor_.number(), stream);
  if (!copied || !named.close()) refuse_write(errno);
  descriptor_.close();
}

void OutputFile::hand_over() {
  std::vector<char> chunk(kBuffered);
  for (std::uint64_t at = 0;;) {
    const std::size_t got = read(at, chunk.data(), chunk.size());
    if (got == 0 && at > 0) break;
    take_({chunk.data(), got});  // once at least: the output may be empty
    if (got == 0) break;
    at += got;
  }
  descriptor_.close();
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace plumbline
