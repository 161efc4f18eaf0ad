#include "base/platform/platform.hpp"

#ifdef __linux__

#include <array>

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace plumbline::platform {
namespace {

constexpr std::uint32_t kWatched =
    IN_CREATE | IN_MODIFY | IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_ONLYDIR;
constexpr std::size_t kBuffer = 65536;

std::optional<ChangeKind> kind_of(std::uint32_t mask) {
  if ((mask & IN_Q_OVERFLOW) != 0) return ChangeKind::lost;
  if ((mask & (IN_DELETE | IN_MOVED_FROM)) != 0) return ChangeKind::gone;
  if ((mask & IN_ISDIR) != 0)
    return (mask & (IN_CREATE | IN_MOVED_TO)) != 0 ? std::optional(ChangeKind::folder) : std::nullopt;
  if ((mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) != 0) return ChangeKind::finished;
  if ((mask & (IN_CREATE | IN_MODIFY)) != 0) return ChangeKind::begun;
  return std::nullopt;
}

}  // namespace

int open_changes() { return inotify_init1(IN_CLOEXEC | IN_NONBLOCK); }

int watch_folder(int changes, const std::string& folder) {
  return inotify_add_watch(changes, folder.c_str(), kWatched);
}

std::vector<Change> wait_for_changes(int changes, int most_ms) {
  std::vector<Change> found;
  pollfd ready{changes, POLLIN, 0};
  if (poll(&ready, 1, most_ms) <= 0) return found;
  alignas(inotify_event) std::array<char, kBuffer> buffer;
  for (ssize_t got = 0; (got = ::read(changes, buffer.data(), buffer.size())) > 0;) {
    for (const char* at = buffer.data(); at < buffer.data() + got;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(at);
      at += sizeof(inotify_event) + event->len;
      if (const auto kind = kind_of(event->mask))
        found.push_back({*kind, event->wd, event->len > 0 ? event->name : ""});
    }
  }
  return found;
}

}  // namespace plumbline::platform

#else

namespace plumbline::platform {

int open_changes() { return -1; }
int watch_folder(int /*changes*/, const std::string& /*folder*/) { return -1; }
std::vector<Change> wait_for_changes(int /*changes*/, int /*most_ms*/) { return {}; }

}  // namespace plumbline::platform

#endif
