#include "base/text/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

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

int digits_of(std::uint64_t number) {
  int count = 1;
  for (; number >= 10; number /= 10) ++count;
  return count;
}

// The last `count` digits of a number, before `end`.
void put_digits(char* end, std::uint64_t number, int count) {
  for (; count >= 2; count -= 2) {
    const std::uint64_t pair = number % 100;
    number /= 100;
    *--end = kPairs[2 * pair + 1];
    *--end = kPairs[2 * pair];
  }
  if (count > 0) *--end = static_cast<char>('0' + number % 10);
}

}  // namespace

char* write_decimal(char* out, double value, int decimals, int least) {
  // A number has no more digits than a double: those that would be beyond are noise.
  while (decimals > 0 && std::abs(value) * power_of_ten(decimals) >= kLargestExact - 1) --decimals;
  if (std::abs(value) >= kLargestExact - 1) return fmt::format_to(out, "{:.0f}", value);
  const std::int64_t ticks = to_ticks(value, decimals);
  auto left = static_cast<std::uint64_t>(std::abs(ticks));
  while (decimals > least && left % 10 == 0) {
    left /= 10;
    --decimals;
  }
  if (ticks < 0) *out++ = '-';
  const auto parts = static_cast<std::uint64_t>(kPowersOfTen[static_cast<std::size_t>(decimals)]);
  const std::uint64_t whole = left / parts;
  const std::uint64_t rest = left - whole * parts;
  const int digits = digits_of(whole);
  put_digits(out += digits, whole, digits);
  if (decimals == 0) return out;
  *out++ = '.';
  put_digits(out += decimals, rest, decimals);
  return out;
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
