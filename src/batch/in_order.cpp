#include "batch/in_order.hpp"

#include <utility>

#include "batch/program_list.hpp"

namespace plumbline::batch {

using State = jobs::BatchItem::State;

void InOrder::take(std::size_t number, jobs::BatchItem item) {
  ++taken_;
  if (observer_.progress) observer_.progress(taken_, count_);
  waiting_.emplace(number, std::move(item));
  for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_; first = waiting_.begin()) {
    jobs::BatchItem told = std::move(first->second);
    waiting_.erase(first);
    ++next_;
    if (told.state == State::failed) {
      failed_.push_back(std::move(told));
    } else {
      tell(std::move(told));
    }
  }
}

void InOrder::finish(const std::set<std::string>& called) {
  for (jobs::BatchItem& item : failed_) {
    if (called.contains(whole_path(item.program))) {
      item.state = State::subprogram;
    }
    tell(std::move(item));
  }
  failed_.clear();
}

void InOrder::tell(jobs::BatchItem item) {
  std::size_t& count = item.state == State::done         ? summary_.done
                       : item.state == State::unchanged  ? summary_.unchanged
                       : item.state == State::failed     ? summary_.failed
                       : item.state == State::subprogram ? summary_.subprograms
                                                         : summary_.compensated;
  ++count;
  if (observer_.item) observer_.item(item);
}

}  // namespace plumbline::batch
