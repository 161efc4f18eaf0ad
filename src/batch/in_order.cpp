#include "batch/in_order.hpp"

#include <filesystem>
#include <utility>

#include "base/files/path_of.hpp"

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
    if (called.contains(std::filesystem::absolute(path_of(item.program)).lexically_normal().generic_string())) {
      item.state = State::subprogram;
    }
    tell(std::move(item));
  }
  failed_.clear();
}

void InOrder::tell(jobs::BatchItem item) {
  std::size_t& count = item.state == State::done        ? summary_.done
                       : item.state == State::unchanged ? summary_.unchanged
                       : item.state == State::failed    ? summary_.failed
                                                        : summary_.subprograms;
  ++count;
  if (observer_.item) observer_.item(item);
}

}  // namespace plumbline::batch
