// What a control keeps of the numbers that it is given: no more than its increment system has decimals.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/text/number_text.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::nc {

struct Kept {
  double quantum = 0;  // in the program's unit; 0: whatever is written
  int decimals = 0;
};

/// Of a length or an angle. `ratio`: --input-increment over the dialect's own.
Kept kept_of(const ControlBehaviour& behaviour, bool angle, bool inches, double ratio);

/// Of a word of an axis that is written; `incremental`: under G91, where what is rounded away would add up.
Kept kept_of_axis_word(const ControlBehaviour& behaviour, bool angle, bool inches, double ratio, bool incremental);

/// The value as the control keeps it: a number that stands in the program is cut off, one that is worked out rounded.
double kept_value(double value, const Kept& kept, bool is_literal);

/// How a number is written, in the unit of its word.
struct WrittenNumber {
  int digits = kMostDecimals;
  double quantum = 1e-9;

  double kept(double value) const {
    const double quanta = value / quantum;
    // Where the quantum is the last digit, its multiples are the ticks.
    const double power = kPowersOfTen[static_cast<std::size_t>(digits)];
    const bool of_digits = quantum * power == 1 && std::abs(quanta) < kSureTicks;
    return of_digits ? static_cast<double>(nearest_whole(quanta)) / power : kept_of_quanta(quanta);
  }

 private:
  static constexpr double kSureTicks = 1e14;  // so many last digits are no tick off, however they were multiplied
  double kept_of_quanta(double quanta) const;
};
/// `digits` and `increment`: those that are asked for, where the control keeps as many.
WrittenNumber written_number(const Kept& kept, int digits, double increment);

}  // namespace plumbline::nc
