#include "report/text_table.hpp"

#include <cmath>

#include <fmt/format.h>

namespace plumbline::report {

std::string time_text(double seconds) {
  if (seconds < 59.995) return fmt::format("{:.2f} s", seconds);
  const double tenths = std::round(seconds * 10);
  const double minutes = std::floor(tenths / 600);
  const double rest = (tenths - minutes * 600) / 10;
  if (minutes < 60) return fmt::format("{:.0f} min {:04.1f} s", minutes, rest);
  const double hours = std::floor(minutes / 60);
  return fmt::format("{:.0f} h {:02.0f} min {:04.1f} s", hours, minutes - hours * 60, rest);
}

std::string count_text(std::uint64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string count_text(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count_text(count), noun, count == 1 ? "" : "s");
}

}  // namespace plumbline::report
