// How far the work has come, on a terminal.
#pragma once

#include <chrono>
#include <cstdint>

#include "base/progress.hpp"

namespace plumbline::cli {

/// A line on standard error that is written over again and taken away at the end. Silent where that is no terminal.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// For the libraries; must not outlive this. Empty where there is no terminal.
  Progress progress();
  /// Takes the line away.
  void clear();

 private:
  void show(std::uint64_t done, std::uint64_t total);
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace plumbline::cli
