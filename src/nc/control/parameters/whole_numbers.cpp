#include "nc/control/parameters/whole_numbers.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {

void check_range(const Block& block, Span span, const Value& value) {
  constexpr double kLargest = 2147483647;
  if (!value.known || value.vacant || std::abs(value.number) <= kLargest) return;
  refuse_at(block, span, codes::kOutOfRange,
            fmt::format("an INT goes to {:.0f}, and {:.10g} is beyond", kLargest, value.number), "declare it as REAL");
}

void check_half(const Block& block, Span span, const Value& value) {
  constexpr double kHalf = 0.5;
  constexpr double kNear = 1e-9;
  if (!value.known) return;
  const double below = std::trunc(value.number) + std::copysign(kHalf, value.number) - value.number;
  if (std::abs(below) > kNear || (value.number > 0 && below <= 0)) return;
  refuse_at(
      block, span, codes::kNotInterpreted,
      fmt::format("{:.6g} lies {}halfway between two whole numbers, and which of them the control rounds it to was "
                  "found in no source{}",
                  value.number, below == 0 ? "" : "but for its last digits ", value.number < 0 ? " below 0" : ""),
      value.number < 0 ? "round the number without its sign, as in -ROUND(2.5), or add or take off 0.001 before"
                       : "add or take off 0.001 before");
}

double rounded(const Block& block, Span span, double value, const Rounding& rounding) {
  // Half is added and the rest cut off: what is less than a half by its last digit alone goes up [LinuxCNC,
  // interp_execute.cc].
  const double whole = std::trunc(value + std::copysign(0.5, value));
  if (rounding.known && rounding.quantum == 1) {
    if (std::abs(value) < kLargestInteger) return whole;
    refuse_at(block, span, codes::kArithmetic,
              fmt::format("{:.6g} is more than a whole number of the control holds", value),
              "look for a slip: ROUND gives whole numbers up to 2147483647");
  }
  if (rounding.known && std::abs(value) > kLargestWhole) return value;
  if (rounding.known)
    return from_ticks(to_ticks(std::round(value / rounding.quantum) * rounding.quantum, kMostDecimals), kMostDecimals);
  if (std::abs(value - whole) <= kWhole) return whole;
  refuse_at(block, span, codes::kNotInterpreted,
            fmt::format("ROUND of {:.6g}: in a word it rounds to what the control keeps of that word, and for this one "
                        "no source says what that is",
                        value),
            "round it before, into a variable: that gives whole numbers");
}

int whole_number(const Block& block, Span span, double value, std::string_view what) {
  const double whole = std::round(value);
  if (std::abs(whole) > kLargestWhole) {
    refuse_at(block, span, codes::kNotWhole, fmt::format("{} is {:.6g}, which is too large", what, value),
              "look for a slip: no such number has as many digits");
  }
  if (std::abs(value - whole) > kWhole) {
    refuse_at(block, span, codes::kNotWhole, fmt::format("{} is no whole number", what), "write a whole number");
  }
  return static_cast<int>(whole);
}

int parameter_number(const Block& block, Span span, Value value, ParameterLimits limits) {
  if (!value.known) {
    refuse_at(block, span, codes::kValueUnknown, "which parameter this is depends on what only the machine knows",
              "write the number of the parameter itself");
  }
  const int number = whole_number(block, span, value.number, "the number of a parameter");
  if (number < limits.first || number > limits.last) {
    refuse_at(block, span, codes::kParameterNumber, fmt::format("there is no parameter #{}", number),
              fmt::format("parameters have the numbers {} to {}", limits.first, limits.last));
  }
  return number;
}

}  // namespace plumbline::nc
