#include "base/files/descriptor.hpp"

#include <cerrno>
#include <vector>

#include <unistd.h>

namespace plumbline {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 16U;

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

bool copy_all(int from, int to) {
  std::vector<char> chunk(kChunk);
  while (true) {
    const ssize_t count = ::read(from, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    if (!write_all(to, chunk.data(), static_cast<std::size_t>(count))) return false;
  }
}

}  // namespace plumbline
