#include "base/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace plumbline {
namespace {

// "00" to "99"
constexpr std::array<char, 200> kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

// The last `count` digits of a number, before `end`: they are taken off it.
char* put_digits(char* end, std::uint64_t& left, int count) {
  for (; count >= 2; count -= 2) {
    end -= 2;
    std::memcpy(end, kPairs.data() + 2 * (left % 100), 2);
    left /= 100;
  }
  if (count == 0) return end;
  *--end = static_cast<char>('0' + left % 10);
  left /= 10;
  return end;
}

// 1, 10, ... to 10^18
constexpr std::array<std::uint64_t, 19> kWholePowers = [] {
  std::array<std::uint64_t, 19> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

// 1 of 0 to 9. Without branches, which nobody could foretell.
int count_digits(std::uint64_t value) {
  constexpr unsigned kLog2 = 1233;  // log10(2) x 4096
  const std::uint64_t counted = value | 1U;
  const unsigned at_least = static_cast<unsigned>(std::bit_width(counted)) * kLog2 >> 12U;
  return static_cast<int>(at_least) + static_cast<int>(counted >= kWholePowers[at_least]);
}

}  // namespace

char* write_decimal(char* out, double value, int decimals, int least) {
  // A number has no more digits than a double: those that would be beyond are noise.
  double scaled = value * power_of_ten(decimals);
  while (decimals > 0 && std::abs(scaled) >= kLargestExact - 1) scaled = value * power_of_ten(--decimals);
  if (std::abs(scaled) >= kLargestExact - 1) return fmt::format_to(out, "{:.0f}", value);
  const std::int64_t ticks = nearest_whole(scaled);
  auto left = static_cast<std::uint64_t>(std::abs(ticks));
  while (decimals > least && left % 10 == 0) {
    left /= 10;
    --decimals;
  }
  *out = '-';
  char* const begin = out + (ticks < 0 ? 1 : 0);
  char* const end = begin + std::max(count_digits(left), decimals + 1) + (decimals > 0 ? 1 : 0);
  char* at = end;
  if (decimals > 0) {
    at = put_digits(at, left, decimals);
    *--at = '.';
  }
  put_digits(at, left, static_cast<int>(at - begin));
  return end;
}

void append_decimal(std::string& out, double value, int decimals, int least) {
  std::array<char, kDecimalRoom> text;  // NOLINT(*-member-init)
  const char* const end = write_decimal(text.data(), value, decimals, least);
  out.append(text.data(), static_cast<std::size_t>(end - text.data()));
}

std::string to_decimal(double value, int decimals, int least) {
  std::string out;
  append_decimal(out, value, decimals, least);
  return out;
}

std::string exact_decimal(double value) {
  std::array<char, 2 * kDecimalRoom> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value + 0.0, std::chars_format::fixed);
  PLUMBLINE_CHECK(error == std::errc{} && std::isfinite(value));
  return {text.data(), end};
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
