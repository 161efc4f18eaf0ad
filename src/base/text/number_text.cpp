#include "base/text/number_text.hpp"

#include <array>
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

// The last `count` digits, before `end`.
char* put_digits(char* end, std::uint64_t& left, int count) {
  for (; count >= 2; count -= 2) {
    const std::uint64_t pair = left % 100;
    left /= 100;
    *--end = kPairs[2 * pair + 1];
    *--end = kPairs[2 * pair];
  }
  if (count == 0) return end;
  *--end = static_cast<char>('0' + left % 10);
  left /= 10;
  return end;
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
  std::array<char, 24> text;  // NOLINT(*-member-init): from its end: 16 digits at most, point, sign
  char* const end = text.data() + text.size();
  char* begin = end;
  if (decimals > 0) {
    begin = put_digits(begin, left, decimals);
    *--begin = '.';
  }
  while (left >= 10) begin = put_digits(begin, left, 2);
  if (left > 0 || begin == end || *begin == '.') begin = put_digits(begin, left, 1);
  if (ticks < 0) *--begin = '-';
  const auto size = static_cast<std::size_t>(end - begin);
  std::memcpy(out, begin, size);
  return out + size;
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
