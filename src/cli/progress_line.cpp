#include "cli/progress_line.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "base/platform/platform.hpp"
#include "cli/messages.hpp"
#include "cli/terminal.hpp"
#include "report/progress_text.hpp"

namespace plumbline::cli {
namespace {

constexpr std::chrono::milliseconds kFirst{500};
constexpr std::chrono::milliseconds kEvery{200};

// The last column stays free: a full line would go over into the next one.
std::size_t width() { return columns(Stream::err) - 1; }

bool asks_for_filter_progress() { return platform::environment("AXIS_PROGRESS_BAR") == "1" && !says_json(); }

}  // namespace

ProgressLine::ProgressLine(std::string_view work)
    : work_(work),
      is_for_axis_(asks_for_filter_progress()),
      is_wanted_(!is_for_axis_ && is_terminal(Stream::err) && loudness() != Loudness::quiet),
      begin_(std::chrono::steady_clock::now()),
      next_(is_for_axis_ ? begin_ : begin_ + kFirst) {}

ProgressLine::~ProgressLine() { clear(); }

Progress ProgressLine::progress() {
  if (!is_wanted_ && !is_for_axis_) return {};
  return [this](std::uint64_t done, std::uint64_t total) { show(done, total); };
}

void ProgressLine::show(std::uint64_t done, std::uint64_t total) {
  const auto now = std::chrono::steady_clock::now();
  if (total == 0 || now < next_) return;
  next_ = now + kEvery;
  if (is_for_axis_) {
    std::fputs(fmt::format("FILTER_PROGRESS={}\n", 100 * done / total).c_str(), stderr);
    std::fflush(stderr);
    return;
  }
  const std::chrono::duration<double> since = now - begin_;
  put(report::progress_text(work_, done, total, since.count(), width()));
}

void ProgressLine::begin(std::string_view what) {
  if (!is_wanted_ || loudness() == Loudness::verbose) return;
  put(fmt::format("{}: {}", work_, what).substr(0, width()));
}

void ProgressLine::put(const std::string& text) {
  std::fputs(fmt::format("\r{:<{}}", text, shown_).c_str(), stderr);
  std::fflush(stderr);
  shown_ = text.size();
}

void ProgressLine::clear() {
  if (shown_ == 0) return;
  std::fputs(fmt::format("\r{:<{}}\r", "", shown_).c_str(), stderr);
  shown_ = 0;
}

}  // namespace plumbline::cli
