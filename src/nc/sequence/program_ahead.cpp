#include "nc/sequence/program_ahead.hpp"

#include <array>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

#include "base/parallel.hpp"
#include "nc/sequence/kept_steps.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kBatches = StepsAhead::kPlaces;
constexpr std::size_t kHalf = kBatches / 2;

}  // namespace

// Batches go round between the two threads: those from taken to filled wait to be taken. When none is empty, the reader
// waits until half of them are: to wake a thread costs as much as some dozens of blocks.
struct ProgramAhead::Reader {
  Reader(Program& program_, StepsAhead* looks_) : program(program_), looks(looks_) {}
  ~Reader() {
    if (!thread.joinable()) return;
    {
      const std::lock_guard lock(mutex);
      stopped = true;
    }
    changed.notify_all();
    thread.join();
  }
  Reader(Reader&&) = delete;
  Reader& operator=(Reader&&) = delete;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  // The thread may run before it has come to its name here.
  void start() {
    threaded = true;
    try {
      thread = std::thread([this] { read(); });
    } catch (const std::system_error&) {  // no thread to be had
      threaded = false;
    }
  }
  void read();
  void fill(KeptSteps& batch);
  void look_at(KeptSteps& batch) const;
  KeptSteps* empty_batch();
  void take_batch();
  const KeptSteps::Kept* next();
  // Without a thread it is always the same one, whose memory the processor has at hand.
  std::size_t place_of(std::size_t batch) const { return threaded ? batch % kBatches : 0; }

  Program& program;
  StepsAhead* looks;
  FileNames files;
  std::array<KeptSteps, kBatches> batches;
  const Step* waiting = nullptr;  // a step that did not fit into the batch before
  std::mutex mutex;
  std::condition_variable changed;
  std::size_t filled = 0, taken = 0;  // batches so far
  bool stopped = false;
  bool threaded = false;
  bool holds = false;  // the batch that is taken from was filled
  std::size_t at = 0;  // of this, the next step
  std::thread thread;
};

KeptSteps* ProgramAhead::Reader::empty_batch() {
  std::unique_lock lock(mutex);
  if (filled - taken == kBatches) changed.wait(lock, [&] { return stopped || filled - taken <= kHalf; });
  return stopped ? nullptr : &batches[place_of(filled)];
}

void ProgramAhead::Reader::fill(KeptSteps& batch) {
  batch.clear();
  try {
    while (true) {
      const Step* const step = waiting != nullptr ? waiting : program.next();
      waiting = nullptr;
      if (step == nullptr) return batch.end();
      if (batch.add(*step, program, files)) continue;
      waiting = step;
      return;
    }
  } catch (...) {
    batch.end(std::current_exception());
  }
}

void ProgramAhead::Reader::look_at(KeptSteps& batch) const {
  if (looks == nullptr) return;
  try {
    looks->look(batch, place_of(filled));
  } catch (...) {
    batch.end(std::current_exception());
  }
}

void ProgramAhead::Reader::read() {
  for (bool goes_on = true; goes_on;) {
    KeptSteps* const batch = empty_batch();
    if (batch == nullptr) return;
    fill(*batch);
    look_at(*batch);
    goes_on = !batch->is_last();
    bool wakes = false;
    {
      const std::lock_guard lock(mutex);
      wakes = filled++ == taken;
    }
    if (wakes) changed.notify_all();
  }
}

void ProgramAhead::Reader::take_batch() {
  if (threaded) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return filled > taken; });
  } else {
    fill(batches.front());
    look_at(batches.front());
    ++filled;
  }
  holds = true;
}

const KeptSteps::Kept* ProgramAhead::Reader::next() {
  while (true) {
    if (!holds) take_batch();
    const KeptSteps& batch = batches[place_of(taken)];
    if (at < batch.size()) return &batch[at++];
    if (batch.refusal()) std::rethrow_exception(batch.refusal());
    if (batch.is_last()) return nullptr;
    at = 0;
    holds = false;
    bool wakes = false;
    {
      const std::lock_guard lock(mutex);
      wakes = filled - ++taken == kHalf;
    }
    if (wakes) changed.notify_all();
  }
}

ProgramAhead::ProgramAhead(const InputFile& file, const Dialect& dialect, ProgramSettings settings, StepsAhead* looks)
    : program_(file, dialect, std::move(settings)) {
  const bool alone = processors() == 1;
  if (alone && looks == nullptr) return;
  reader_ = std::make_unique<Reader>(program_, looks);
  if (!alone) reader_->start();
}

ProgramAhead::~ProgramAhead() = default;

// Only the thread that takes them counts those that were taken.
std::uint64_t ProgramAhead::handed_over() const { return reader_ ? reader_->taken + 1 : 0; }
std::size_t ProgramAhead::place() const { return reader_ ? reader_->place_of(reader_->taken) : 0; }

const Step* ProgramAhead::next_in_place() {
  const Step* const step = program_.next();
  jumped_ = program_.jumped();
  position_read_ = program_.position_read();
  return step;
}

const Step* ProgramAhead::next() {
  if (!reader_) return next_in_place();
  const KeptSteps::Kept* const kept = reader_->next();
  if (kept == nullptr) return nullptr;
  jumped_ = kept->jumped;
  position_read_ = kept->position_read;
  return &kept->step;
}

}  // namespace plumbline::nc
