// What a control keeps of the numbers that it is given: no more than its increment system has decimals.
#pragma once

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

struct Kept {
  double quantum = 0;  // in the program's unit; 0: whatever is written
  int decimals = 0;
};

/// Of a length or an angle. `ratio`: --input-increment over the dialect's own.
Kept kept_of(const ControlBehaviour& behaviour, bool angle, bool inches, double ratio);

/// Of a word of an axis; `incremental`: under G91, where what is rounded away would add up.
Kept kept_of_axis_word(const ControlBehaviour& behaviour, bool angle, bool inches, double ratio, bool incremental);

/// The value as the control keeps it: a number that stands in the program is cut off, one that is worked out rounded.
double kept_value(double value, const Kept& kept, bool is_literal);

/// How a number is written, in the unit of its word.
struct WrittenNumber {
  int digits = 9;
  double quantum = 1e-9;

  double kept(double value) const;
};
/// `digits` and `increment`: those that are asked for, where the control keeps as many.
WrittenNumber written_number(const Kept& kept, int digits, double increment);

}  // namespace plumbline::nc
