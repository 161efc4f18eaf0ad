#include "base/files/ending_signals.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "base/platform/platform.hpp"

namespace plumbline {

// Slots are never freed, only used again, so that a handler may walk them at any moment.
struct PassingName::Slot {
  std::atomic<char*> path = nullptr;
  std::atomic<bool> taken = true;
  Slot* next = nullptr;
};

namespace {

constexpr int kDying = -1;
constexpr int kMostLevels = 8;  // of new folders in new folders

std::atomic<PassingName::Slot*> slots = nullptr;
std::atomic<int> waits = 0;    // SignalsWaits alive, or kDying
std::atomic<int> pending = 0;  // a signal that came meanwhile
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<char*>::is_always_lock_free);

// Files first: a folder has to be empty.
void remove_all_names() {
  for (PassingName::Slot* slot = slots.load(); slot != nullptr; slot = slot->next) {
    char* const path = slot->path.exchange(nullptr);
    if (path != nullptr && !platform::remove_name(path)) slot->path = path;
  }
  for (int level = 0; level < kMostLevels; ++level) {
    for (PassingName::Slot* slot = slots.load(); slot != nullptr; slot = slot->next) {
      if (const char* const path = slot->path.load()) platform::remove_name(path);
    }
  }
}

// Runs at any moment on any thread: atomics and system calls alone.
void end_by(int signal) {
  const int error = errno;
  pending = signal;
  int none = 0;
  if (!waits.compare_exchange_strong(none, kDying)) {
    errno = error;
    return;  // whoever waits raises it again, or another thread is ending the process
  }
  remove_all_names();
  platform::end_by(signal);
}

PassingName::Slot* free_slot() {
  for (PassingName::Slot* slot = slots.load(); slot != nullptr; slot = slot->next) {
    bool taken = false;
    if (slot->taken.compare_exchange_strong(taken, true)) return slot;
  }
  auto* const slot = new PassingName::Slot;
  slot->next = slots.load();
  while (!slots.compare_exchange_weak(slot->next, slot)) {
  }
  return slot;
}

}  // namespace

void remove_names_on_signals() { platform::call_at_end(end_by); }

PassingName::PassingName(std::string path) : path_(std::move(path)), slot_(free_slot()) {
  char* const copy = strdup(path_.c_str());
  if (copy == nullptr) {
    slot_->taken = false;
    throw std::bad_alloc();
  }
  slot_->path = copy;
}

PassingName::PassingName(PassingName&& other) noexcept
    : path_(std::move(other.path_)), slot_(std::exchange(other.slot_, nullptr)) {}

PassingName& PassingName::operator=(PassingName&& other) noexcept {
  if (this != &other) {
    remove();
    path_ = std::move(other.path_);
    slot_ = std::exchange(other.slot_, nullptr);
  }
  return *this;
}

PassingName::~PassingName() { remove(); }

void PassingName::remove() {
  if (slot_ == nullptr) return;
  platform::remove_name(path_.c_str());
  let_go();
}

void PassingName::let_go() {
  if (slot_ == nullptr) return;
  std::free(slot_->path.exchange(nullptr));
  slot_->taken = false;
  slot_ = nullptr;
}

SignalsWait::SignalsWait() {
  int count = waits.load();
  while (count == kDying || !waits.compare_exchange_weak(count, count + 1)) {
    if (count != kDying) continue;
    platform::wait_for_end();
    count = waits.load();
  }
}

SignalsWait::~SignalsWait() {
  if (waits.fetch_sub(1) != 1) return;
  if (const int signal = pending.exchange(0)) end_by(signal);
}

}  // namespace plumbline
