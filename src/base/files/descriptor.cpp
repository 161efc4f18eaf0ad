#include "base/files/descriptor.hpp"

#include <cerrno>
#include <utility>
#include <vector>

#include "base/platform/platform.hpp"

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

bool Descriptor::close() { return !is_open() || platform::close(release()); }

std::string way_out(int error, std::string usual) {
  if (error != EMFILE && error != ENFILE) return usual;
  return "too many files are open: allow more (ulimit -n), or do less at a time (--jobs)";
}

bool write_all(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const std::ptrdiff_t written = platform::write(descriptor, bytes, count);
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

bool copy_all(int from, int to, const std::function<void(std::string_view)>& look) {
  std::vector<char> chunk(kChunk);
  while (true) {
    const std::ptrdiff_t count = platform::read(from, chunk.data(), chunk.size());
    if (count <= 0) return count == 0;
    if (look) look({chunk.data(), static_cast<std::size_t>(count)});
    if (!write_all(to, chunk.data(), static_cast<std::size_t>(count))) return false;
  }
}

}  // namespace plumbline
