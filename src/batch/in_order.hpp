// Programs are done in any order, and told of in that of the list.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "batch/batch.hpp"

namespace plumbline::batch {

/// Not thread-safe.
class InOrder {
 public:
  InOrder(const Observer& observer, std::size_t count) : observer_(observer), count_(count) {}

  /// The item of this number, which has become what it will be.
  void take(std::size_t number, jobs::BatchItem item);
  /// Tells of those that failed; one that is among the `called` files is a subprogram. Absolute paths.
  void finish(const std::set<std::string>& called);
  const jobs::BatchSummary& summary() const { return summary_; }

 private:
  void tell(jobs::BatchItem item);

  const Observer& observer_;
  std::size_t count_;
  std::size_t next_ = 0;  // number to tell of
  std::size_t taken_ = 0;
  std::map<std::size_t, jobs::BatchItem> waiting_;
  std::vector<jobs::BatchItem> failed_;
  jobs::BatchSummary summary_;
};

}  // namespace plumbline::batch
