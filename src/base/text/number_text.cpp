#include "base/text/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace plumbline {
namespace {

constexpr std::size_t kMostSigns = 24;  // of a number within kLargestExact: 16 digits, point, sign, some more

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
    end -= 2;
    std::memcpy(end, kPairs.data() + 2 * (left % 100), 2);
    left /= 100;
  }
  if (count == 0) return end;
  *--end = static_cast<char>('0' + left % 10);
  left /= 10;
  return end;
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
  std::array<char, 2 * kMostSigns> text{};  // the number ends in its middle, so that as many signs can be copied always
  char* const end = text.data() + kMostSigns;
  char* begin = end;
  if (decimals > 0) {
    begin = put_digits(begin, left, decimals);
    *--begin = '.';
  }
  while (left >= 10) begin = put_digits(begin, left, 2);
  if (left > 0 || begin == end || *begin == '.') begin = put_digits(begin, left, 1);
  if (ticks < 0) *--begin = '-';
  std::memcpy(out, begin, kMostSigns);
  return out + (end - begin);
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
