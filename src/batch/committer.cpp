#include "batch/committer.hpp"

#include <chrono>
#include <utility>

namespace plumbline::batch {
namespace {

constexpr std::size_t kGroup = 128;  // each holds one or two files open
constexpr std::chrono::milliseconds kPatience{100};

}  // namespace

Committer::Committer(Record& record, std::function<void(Work&&)> settled)
    : record_(record), settled_(std::move(settled)), thread_([this] { run(); }) {}

Committer::~Committer() {
  {
    const std::scoped_lock lock(guard_);
    waiting_.clear();
    ends_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

bool Committer::take(Work work) {
  {
    std::unique_lock lock(guard_);
    changed_.wait(lock, [&] { return waiting_.size() < kGroup || has_stopped_; });
    if (has_stopped_) return false;
    waiting_.push_back(std::move(work));
  }
  changed_.notify_all();
  return true;
}

void Committer::finish() {
  {
    const std::scoped_lock lock(guard_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
}

void Committer::run() {
  try {
    for (std::vector<Work> group = next_group(); !group.empty(); group = next_group()) settle(group);
  } catch (...) {
    failure_ = std::current_exception();
  }
  {
    const std::scoped_lock lock(guard_);
    has_stopped_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
}

// Whoever looks on should not wait long for one program, and many are to go together.
std::vector<Work> Committer::next_group() {
  std::vector<Work> group;
  {
    std::unique_lock lock(guard_);
    changed_.wait(lock, [&] { return !waiting_.empty() || ends_; });
    changed_.wait_for(lock, kPatience, [&] { return waiting_.size() >= kGroup || ends_; });
    for (Work& work : waiting_) group.push_back(std::move(work));
    waiting_.clear();
  }
  changed_.notify_all();
  return group;
}

void Committer::settle(std::vector<Work>& group) {
  OutputGroup outputs;
  for (Work& work : group) {
    if (work.undo) outputs.add(*work.undo);
    if (work.output) outputs.add(*work.output);
  }
  outputs.make_last();
  std::vector<const Entry*> entries;
  for (Work& work : group) {
    if (work.output) {
      const std::optional<FileState> state = work.output->state();
      work.entry.output = {state.value_or(FileState()), work.output->hash()};
    }
    entries.push_back(&work.entry);
  }
  record_.put(entries);
  outputs.appear();
  for (Work& work : group) {
    std::optional<Diagnostic> problem;
    if (work.undo) problem = outputs.problem(*work.undo);
    if (work.output && !problem) problem = outputs.problem(*work.output);
    settled_(problem ? failed(work.task, *problem, false) : std::move(work));
  }
}

}  // namespace plumbline::batch
