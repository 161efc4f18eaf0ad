// Numbers as text: no locale, no exponent, no surprise.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/check.hpp"

namespace plumbline {

inline constexpr int kMostDecimals = 9;
inline constexpr std::array<double, kMostDecimals + 1> kPowersOfTen{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
inline constexpr double kLargestExact = 9007199254740992.0;  // 2^53: up to here a double counts one by one

inline double power_of_ten(int decimals) {
  PLUMBLINE_CHECK(decimals >= 0 && decimals <= kMostDecimals);
  return kPowersOfTen[static_cast<std::size_t>(decimals)];
}

/// The nearest whole number of a value within kLargestExact; halves go away from zero, as std::round has it: what is
/// cut off is exact. Without branches, which nobody could foretell.
inline std::int64_t nearest_whole(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  const double rest = value - static_cast<double>(whole);
  return whole + static_cast<std::int64_t>(rest >= 0.5) - static_cast<std::int64_t>(rest <= -0.5);
}

/// value rounded to that many decimals (0..kMostDecimals), counted in units of the last one: 1.2346 at 3 -> 1235.
/// Halves round away from zero. Checks that the result fits 53 bits, so that it is exact.
inline std::int64_t to_ticks(double value, int decimals) {
  const double scaled = value * power_of_ten(decimals);
  PLUMBLINE_CHECK(std::abs(scaled) < kLargestExact);
  return nearest_whole(scaled);
}

/// The number that `ticks` units of the given decimal are.
inline double from_ticks(std::int64_t ticks, int decimals) {
  return static_cast<double>(ticks) / power_of_ten(decimals);
}

/// Appends value rounded to that many decimals; trailing zeros dropped down to `least` decimals, no "-0", no exponent.
void append_decimal(std::string& out, double value, int decimals, int least = 0);
/// The same, to where there is room for kDecimalRoom; returns its end.
char* write_decimal(char* out, double value, int decimals, int least = 0);
inline constexpr std::size_t kDecimalRoom = 400;  // a double without digits behind its point has 310 at most
std::string to_decimal(double value, int decimals = kMostDecimals, int least = 0);

/// The shortest text without an exponent that is this very number.
std::string exact_decimal(double value);

/// The number that the whole of `text` is, exponent allowed; nothing if any of it is no number, or it is not finite.
std::optional<double> parse_number(std::string_view text);

}  // namespace plumbline
