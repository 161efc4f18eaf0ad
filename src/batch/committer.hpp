// Puts outputs into their places, many with few syncs of the disk, on a thread of its own.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "batch/record.hpp"
#include "batch/work.hpp"

namespace plumbline::batch {

/// A group of outputs is made to last under passing names; then the record says what they were made from; then they
/// take their places. Killed before the last step, the next run makes them anew; killed after it, it finds them.
class Committer {
 public:
  /// `record` must outlive it. `settled` is told of each program, by one thread.
  Committer(Record& record, std::function<void(Work&&)> settled);
  /// What waits is dropped.
  ~Committer();
  Committer(const Committer&) = delete;
  Committer& operator=(const Committer&) = delete;

  /// Waits while many are waiting. False: it has stopped, and nothing more is to be done.
  bool take(Work work);
  /// Waits until all are in their places. Throws what stopped it.
  void finish();

 private:
  void run();
  std::vector<Work> next_group();
  void settle(std::vector<Work>& group);

  Record& record_;
  std::function<void(Work&&)> settled_;
  std::mutex guard_;
  std::condition_variable changed_;
  std::deque<Work> waiting_;
  bool ends_ = false;
  bool has_stopped_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  // the last: it begins when all else is there
};

}  // namespace plumbline::batch
