// Reads the output while it is written, and holds it against what was meant.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/files/files.hpp"
#include "compensate/read_back/figures.hpp"
#include "compensate/read_back/intention.hpp"
#include "compensate/read_back/output_check.hpp"
#include "nc/syntax/growing_text.hpp"

namespace plumbline::compensate {

/// What was written of an output so far, up to the end of a line; who asks for more waits. The lines of its guard are
/// blank: whether the control stops there is decided on the machine.
class GrowingOutput final : public InputFile, public nc::GrowingText {
 public:
  explicit GrowingOutput(const OutputFile& out) : InputFile(Unopened{out.name()}), out_(out) {}

  /// From now on `size` bytes may be read, `guard` of which are the guard.
  void grow(std::uint64_t size, std::pair<std::uint64_t, std::uint64_t> guard);
  /// There will be no more.
  void end();
  std::size_t read(std::uint64_t offset, char* into, std::size_t count) const override;
  bool ends_block(std::uint64_t offset) const override;
  void check_unchanged() const override {}  // it is being written

 private:
  const OutputFile& out_;
  mutable std::mutex guard_;
  mutable std::condition_variable changed_;
  std::uint64_t size_ = 0;
  std::uint64_t guard_begin_ = 0, guard_end_ = 0;
  bool ended_ = false;
};

class ReadBack {
 public:
  using Span = std::pair<std::uint64_t, std::uint64_t>;

  /// All must outlive it. Starts the thread that reads.
  ReadBack(const InputFile& source, const nc::Dialect& dialect, const nc::ProgramSettings& program,
           const nc::EmitSettings& emit, OutputFile& out, bool unrolled);
  /// Stops reading, whatever was found.
  ~ReadBack();
  ReadBack(ReadBack&&) = delete;

  /// Each batch is shown to `observer` as well, before it is read; to be called before the first is handed over.
  using Observer = std::function<void(const IntendedBatch&)>;
  void show(Observer observer) { observer_ = std::move(observer); }

  /// Hands over what was noted so far once it is much, with the text that was written for it. Refuses with
  /// compensate-read-back as soon as something differs.
  void offer(Intention& intention, Span guard);
  /// Reads to the end.
  ReadBackFigures finish(Intention& intention, Span guard);

 private:
  void hand_over(Intention& intention, Span guard);
  void read();
  void read_batches();

  OutputFile& out_;
  Observer observer_;
  GrowingOutput text_;
  OutputCheck check_;
  std::mutex guard_;
  std::condition_variable changed_;
  std::deque<IntendedBatch> full_;
  std::vector<IntendedBatch> empty_;
  bool stops_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace plumbline::compensate
