#include "cli/progress_line.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/messages.hpp"

namespace plumbline::cli {
namespace {

constexpr std::chrono::milliseconds kFirst{500};
constexpr std::chrono::milliseconds kEvery{200};

}  // namespace

ProgressLine::ProgressLine()
    : is_terminal_(isatty(STDERR_FILENO) == 1 && !says_json()), next_(std::chrono::steady_clock::now() + kFirst) {}

ProgressLine::~ProgressLine() { clear(); }

Progress ProgressLine::progress() {
  if (!is_terminal_) return {};
  return [this](std::uint64_t done, std::uint64_t total) { show(done, total); };
}

void ProgressLine::show(std::uint64_t done, std::uint64_t total) {
  const auto now = std::chrono::steady_clock::now();
  if (total == 0 || now < next_) return;
  next_ = now + kEvery;
  is_shown_ = true;
  std::fputs(fmt::format("\r{:3.0f} %", 100.0 * static_cast<double>(done) / static_cast<double>(total)).c_str(),
             stderr);
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (!is_shown_) return;
  std::fputs("\r      \r", stderr);
  is_shown_ = false;
}

}  // namespace plumbline::cli
