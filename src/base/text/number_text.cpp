#include "base/text/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/check.hpp"

namespace plumbline {
namespace {

constexpr std::array<double, kMostDecimals + 1> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
constexpr double kLargestExact = 9007199254740992.0;  // 2^53

double power_of_ten(int decimals) {
  PLUMBLINE_CHECK(decimals >= 0 && decimals <= kMostDecimals);
  return kPowers[static_cast<std::size_t>(decimals)];
}

}  // namespace

// Halves away from zero, as std::round has it: what is cut off is exact.
std::int64_t to_ticks(double value, int decimals) {
  const double scaled = value * power_of_ten(decimals);
  PLUMBLINE_CHECK(std::abs(scaled) < kLargestExact);
  const auto whole = static_cast<std::int64_t>(scaled);
  const double rest = scaled - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : rest <= -0.5 ? -1 : 0);
}

double from_ticks(std::int64_t ticks, int decimals) { return static_cast<double>(ticks) / power_of_ten(decimals); }

void append_decimal(std::string& out, double value, int decimals, int least) {
  // A number has no more digits than a double: those that would be beyond are noise.
  while (decimals > 0 && std::abs(value) * power_of_ten(decimals) >= kLargestExact - 1) --decimals;
  if (std::abs(value) >= kLargestExact - 1) {
    fmt::format_to(std::back_inserter(out), "{:.0f}", value);
    return;
  }
  const std::int64_t ticks = to_ticks(value, decimals);
  auto left = static_cast<std::uint64_t>(std::abs(ticks));
  while (decimals > least && left % 10 == 0) {
    left /= 10;
    --decimals;
  }
  std::array<char, 24> text{};  // from its end: 16 digits at most, point, sign
  char* const end = text.data() + text.size();
  char* begin = end;
  const auto put_digit = [&] {
    *--begin = static_cast<char>('0' + left % 10);
    left /= 10;
  };
  if (decimals > 0) {
    for (int i = 0; i < decimals; ++i) put_digit();
    *--begin = '.';
  }
  do put_digit();
  while (left > 0);
  if (ticks < 0) *--begin = '-';
  out.append(begin, end);
}

std::string to_decimal(double value, int decimals, int least) {
  std::string out;
  append_decimal(out, value, decimals, least);
  return out;
}

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-') return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace plumbline
