#include "report/progress_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace plumbline::report {
namespace {

constexpr double kFirstGuess = 3;  // s
constexpr double kNothing = 0.01;  // s, that no second is begun for
constexpr std::size_t kLongestBar = 40;
constexpr std::size_t kShortestBar = 8;

}  // namespace

std::string wait_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::ceil(std::max(seconds - kNothing, 0.0)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_text(std::string_view work, std::uint64_t done, std::uint64_t total, double seconds,
                          std::size_t columns) {
  const double part = std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  const std::string percent = fmt::format("{:3.0f} %", std::floor(100 * part));
  std::string left;
  if (seconds >= kFirstGuess && part > 0) left = fmt::format(", {} left", wait_text(seconds * (1 - part) / part));
  const std::size_t words = work.size() + percent.size() + left.size() + 6;  // with the brackets and the blanks
  if (columns < words + kShortestBar) return percent.size() + left.size() <= columns ? percent + left : percent;
  const std::size_t bar = std::min(kLongestBar, columns - words);
  const auto full = static_cast<std::size_t>(part * static_cast<double>(bar));
  return fmt::format("{}  [{}{}]  {}{}", work, std::string(full, '#'), std::string(bar - full, '-'), percent, left);
}

}  // namespace plumbline::report
