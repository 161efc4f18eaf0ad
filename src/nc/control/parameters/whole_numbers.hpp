// Whole numbers of values, as controls take them.
#pragma once

#include <string_view>

#include "nc/control/parameters/parameters.hpp"
#include "nc/language/block.hpp"

namespace plumbline::nc {

inline constexpr double kWhole = 1e-4;  // [LinuxCNC, measured]
inline constexpr double kLargestWhole = 1e9;
inline constexpr double kLargestInteger = 2147483647;  // of 32 bits

/// The numbers that parameters may have.
struct ParameterLimits {
  int first = 1;
  int last = kLastParameter;
};

/// What ROUND rounds to: whole numbers, or what the control keeps of a word.
struct Rounding {
  double quantum = 1;
  bool known = true;  // not known: only whole numbers are
};

/// What ROUND makes of a value. Refuses one that is not whole where it is not known to what it rounds, and one of more
/// than 32 bits (nc-arithmetic).
double rounded(const Block& block, Span span, double value, const Rounding& rounding);

/// Refuses -2.5, and what is less than 2.5 by its last digits alone: which way a control rounds them that rounds from
/// 0.5 on is left open.
void check_half(const Block& block, Span span, const Value& value);
/// What an INT of 32 bits can hold. Refuses more with nc-out-of-range: what the control makes of it was found in no
/// source.
void check_range(const Block& block, Span span, const Value& value);

/// A whole number near `value`; refuses with nc-not-whole. Whole within 1e-4 [LinuxCNC, measured].
int whole_number(const Block& block, Span span, double value, std::string_view what);

/// The number of a parameter; refuses one that is not whole or out of limits.
int parameter_number(const Block& block, Span span, Value value, ParameterLimits limits = {});

}  // namespace plumbline::nc
