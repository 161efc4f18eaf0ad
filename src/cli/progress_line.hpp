// How far the work has come, on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace plumbline::cli {

/// A line on standard error that is written over again and taken away at the end: a bar, and the time that is left.
/// Where LinuxCNC's AXIS runs plumbline as a filter it reads FILTER_PROGRESS=PERCENT there (it sets AXIS_PROGRESS_BAR),
/// with -q, too. Else silent where standard error is no terminal, and with -q.
class ProgressLine {
 public:
  /// `work`: what takes the time, as "compensate".
  explicit ProgressLine(std::string_view work);
  ~ProgressLine();
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// For the libraries; must not outlive this. Empty where there is no terminal.
  Progress progress();
  /// What is begun now, in words, where nobody knows how long it takes: at once, in place of what was shown. Not with
  /// -v, which tells more.
  void begin(std::string_view what);
  /// Takes the line away.
  void clear();

 private:
  void show(std::uint64_t done, std::uint64_t total);
  void put(const std::string& text);

  std::string work_;
  bool is_for_axis_;
  bool is_wanted_;
  std::size_t shown_ = 0;  // characters
  std::chrono::steady_clock::time_point begin_, next_;
};

}  // namespace plumbline::cli
