// Batches of work that go to a thread of their own, in order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace plumbline {

/// Calls `take` with each batch that is handed over, on another thread, one after the other. A few batches wait at
/// most, so that memory does not grow; a thread that has to wait does so until half of these are there, or free, since
/// to wake one costs as much as some dozens of blocks. Where there is one processor, or no thread to be had, `take` is
/// called at once.
template <class Batch>
class Relay {
 public:
  explicit Relay(std::function<void(Batch&)> take) : take_(std::move(take)) {
    if (processors() == 1) return;
    try {
      thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {  // no thread to be had
    }
  }
  /// What still waits is dropped.
  ~Relay() { stop(End::dropped); }
  Relay(Relay&&) = delete;
  Relay& operator=(Relay&&) = delete;
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  /// Leaves one that was taken in the batch's place, or a new one. Throws what `take` threw.
  void hand_over(Batch& batch) {
    if (!thread_.joinable()) return take_(batch);
    Batch next{};
    bool wakes = false;
    {
      std::unique_lock lock(guard_);
      if (full_.size() == kWaiting) changed_.wait(lock, [&] { return full_.size() <= kHalf || failure_; });
      if (failure_) std::rethrow_exception(failure_);
      full_.push_back(std::move(batch));
      wakes = full_.size() == kHalf;
      if (!empty_.empty()) {
        next = std::move(empty_.back());
        empty_.pop_back();
      }
    }
    if (wakes) changed_.notify_all();
    batch = std::move(next);
  }
  /// Waits until all were taken; to be called once, at the end. Throws what `take` threw.
  void finish() {
    stop(End::taken);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  enum class End { none, taken, dropped };
  static constexpr std::size_t kWaiting = 8;
  static constexpr std::size_t kHalf = kWaiting / 2;

  void stop(End end) {
    if (!thread_.joinable()) return;
    {
      const std::scoped_lock lock(guard_);
      end_ = end;
    }
    changed_.notify_all();
    thread_.join();
  }
  void run() {
    try {
      while (true) {
        Batch batch{};
        bool wakes = false;
        {
          std::unique_lock lock(guard_);
          if (full_.empty()) changed_.wait(lock, [&] { return full_.size() >= kHalf || end_ != End::none; });
          if (full_.empty() || end_ == End::dropped) return;
          batch = std::move(full_.front());
          full_.pop_front();
          wakes = full_.size() == kHalf;
        }
        if (wakes) changed_.notify_all();
        take_(batch);
        const std::scoped_lock lock(guard_);
        empty_.push_back(std::move(batch));
      }
    } catch (...) {
      const std::scoped_lock lock(guard_);
      failure_ = std::current_exception();
    }
    changed_.notify_all();
  }

  std::function<void(Batch&)> take_;
  std::mutex guard_;
  std::condition_variable changed_;
  std::deque<Batch> full_;
  std::vector<Batch> empty_;
  std::exception_ptr failure_;
  End end_ = End::none;
  std::thread thread_;
};

}  // namespace plumbline
