#include "base/files/folder_events.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>

#ifdef __linux__
#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>
#endif

namespace plumbline {

#ifdef __linux__

namespace {

constexpr std::uint32_t kWatched =
    IN_CREATE | IN_MODIFY | IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_ONLYDIR;
constexpr std::size_t kBuffer = 65536;

std::optional<FolderEvent::Kind> kind_of(std::uint32_t mask) {
  using Kind = FolderEvent::Kind;
  if ((mask & IN_Q_OVERFLOW) != 0) return Kind::lost;
  if ((mask & (IN_DELETE | IN_MOVED_FROM)) != 0) return Kind::gone;
  if ((mask & IN_ISDIR) != 0)
    return (mask & (IN_CREATE | IN_MOVED_TO)) != 0 ? std::optional(Kind::folder) : std::nullopt;
  if ((mask & (IN_CLOSE_WRITE | IN_MOVED_TO)) != 0) return Kind::finished;
  if ((mask & (IN_CREATE | IN_MODIFY)) != 0) return Kind::begun;
  return std::nullopt;
}

}  // namespace

std::optional<FolderEvents> FolderEvents::open() {
  Descriptor queue(inotify_init1(IN_CLOEXEC | IN_NONBLOCK));
  if (!queue.is_open()) return std::nullopt;
  return FolderEvents(std::move(queue));
}

bool FolderEvents::add(const std::string& folder) {
  const int watch = inotify_add_watch(queue_.number(), folder.c_str(), kWatched);
  if (watch >= 0) folders_[watch] = folder;
  return watch >= 0;
}

std::vector<FolderEvent> FolderEvents::wait(std::chrono::milliseconds most) {
  std::vector<FolderEvent> events;
  pollfd ready{queue_.number(), POLLIN, 0};
  if (poll(&ready, 1, static_cast<int>(most.count())) <= 0) return events;
  alignas(inotify_event) std::array<char, kBuffer> buffer;
  for (ssize_t got = 0; (got = read(queue_.number(), buffer.data(), buffer.size())) > 0;) {
    for (const char* at = buffer.data(); at < buffer.data() + got;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(at);
      at += sizeof(inotify_event) + event->len;
      const std::optional<FolderEvent::Kind> kind = kind_of(event->mask);
      if (!kind) continue;
      const std::string folder = *kind == FolderEvent::Kind::lost ? "" : folders_[event->wd];
      events.push_back({*kind, event->len > 0 ? (std::filesystem::path(folder) / event->name).string() : folder});
    }
  }
  return events;
}

#else

std::optional<FolderEvents> FolderEvents::open() { return std::nullopt; }
bool FolderEvents::add(const std::string&) { return false; }
std::vector<FolderEvent> FolderEvents::wait(std::chrono::milliseconds) { return {}; }

#endif

}  // namespace plumbline
