// Numbers as text: no locale, no exponent, no surprise.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline {

inline constexpr int kMostDecimals = 9;

/// value rounded to that many decimals (0..kMostDecimals), counted in units of the last one: 1.2346 at 3 -> 1235.
/// Halves round away from zero. Checks that the result fits 53 bits, so that it is exact.
std::int64_t to_ticks(double value, int decimals);

/// The number that `ticks` units of the given decimal are.
double from_ticks(std::int64_t ticks, int decimals);

/// Appends value rounded to that many decimals; trailing zeros dropped down to `least` decimals, no "-0", no exponent.
void append_decimal(std::string& out, double value, int decimals, int least = 0);
std::string to_decimal(double value, int decimals = kMostDecimals, int least = 0);

/// The number that the whole of `text` is, exponent allowed; nothing if any of it is no number, or it is not finite.
std::optional<double> parse_number(std::string_view text);

}  // namespace plumbline
