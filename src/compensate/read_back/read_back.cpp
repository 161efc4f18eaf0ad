#include "compensate/read_back/read_back.hpp"

#include <algorithm>

namespace plumbline::compensate {
namespace {

constexpr std::size_t kBlocks = 512;  // of a batch, or so many points:
constexpr std::size_t kPoints = 4096;
constexpr std::size_t kWaiting = 8;  // batches that may wait to be read

}  // namespace

void GrowingOutput::grow(std::uint64_t size, std::pair<std::uint64_t, std::uint64_t> guard) {
  {
    const std::scoped_lock lock(guard_);
    guard_begin_ = guard.first;
    guard_end_ = guard.second;
    size_ = size;
  }
  changed_.notify_all();
}

void GrowingOutput::end() {
  {
    const std::scoped_lock lock(guard_);
    ended_ = true;
  }
  changed_.notify_all();
}

std::size_t GrowingOutput::read(std::uint64_t offset, char* into, std::size_t count) const {
  std::unique_lock lock(guard_);
  changed_.wait(lock, [&] { return offset < size_ || ended_; });
  const std::uint64_t size = size_;
  const std::uint64_t guard_begin = guard_begin_;
  const std::uint64_t guard_end = guard_end_;
  lock.unlock();
  if (offset >= size) return 0;
  const std::size_t got =
      out_.read(offset, into, static_cast<std::size_t>(std::min<std::uint64_t>(count, size - offset)));
  const std::uint64_t end = std::min<std::uint64_t>(guard_end, offset + got);
  for (std::uint64_t at = std::max<std::uint64_t>(guard_begin, offset); at < end; ++at) {
    char& c = into[at - offset];
    if (c != '\n' && c != '\r') c = ' ';
  }
  return got;
}

bool GrowingOutput::ends_block(std::uint64_t offset) const {
  const std::scoped_lock lock(guard_);
  return offset == size_;
}

ReadBack::ReadBack(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
                   const nc::EmitSettings& emit, OutputFile& out, bool unrolled)
    : out_(out), text_(out), check_(source, text_, dialect, program, emit, unrolled), thread_([this] { read(); }) {}

ReadBack::~ReadBack() {
  {
    const std::scoped_lock lock(guard_);
    stops_ = true;
  }
  changed_.notify_all();
  text_.end();
  if (thread_.joinable()) thread_.join();
}

void ReadBack::offer(Intention& intention, Span guard) {
  const IntendedBatch& batch = intention.batch();
  if (batch.blocks.size() >= kBlocks || batch.points.size() >= kPoints) hand_over(intention, guard);
}

// The text goes out before what it shall mean: the reader never waits for text of a block that it was told of. It must
// not wait for the text behind either, since thousands of blocks may write none.
void ReadBack::hand_over(Intention& intention, Span guard) {
  if (observer_) observer_(intention.batch());
  out_.flush();
  text_.grow(out_.size(), guard);
  IntendedBatch next;
  {
    std::unique_lock lock(guard_);
    changed_.wait(lock, [&] { return full_.size() < kWaiting || failure_ != nullptr; });
    if (failure_) std::rethrow_exception(failure_);
    full_.push_back(std::move(intention.batch()));
    if (!empty_.empty()) {
      next = std::move(empty_.back());
      empty_.pop_back();
    }
  }
  changed_.notify_all();
  intention.batch() = std::move(next);
  intention.start_batch();
}

ReadBackFigures ReadBack::finish(Intention& intention, Span guard) {
  intention.batch().last = true;
  hand_over(intention, guard);
  text_.end();
  thread_.join();
  if (failure_) std::rethrow_exception(failure_);
  return check_.figures();
}

void ReadBack::read() {
  try {
    read_batches();
  } catch (...) {
    const std::scoped_lock lock(guard_);
    failure_ = std::current_exception();
  }
  changed_.notify_all();
}

void ReadBack::read_batches() {
  bool last = false;
  while (!last) {
    IntendedBatch batch;
    {
      std::unique_lock lock(guard_);
      changed_.wait(lock, [&] { return !full_.empty() || stops_; });
      if (stops_) return;
      batch = std::move(full_.front());
      full_.pop_front();
    }
    changed_.notify_all();
    check_.take(batch);
    last = batch.last;
    const std::scoped_lock lock(guard_);
    empty_.push_back(std::move(batch));
  }
  check_.finish();
}

}  // namespace plumbline::compensate
