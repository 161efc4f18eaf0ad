// Values of expressions: runs the postfix code that the parser made.
#pragma once

#include <cstdint>
#include <vector>

#include "nc/control/parameters/parameters.hpp"
#include "nc/control/parameters/relations.hpp"
#include "nc/control/parameters/whole_numbers.hpp"
#include "nc/language/block.hpp"

namespace plumbline::nc {

/// Who knows what a parameter is worth now.
class ParameterReader {
 public:
  virtual ~ParameterReader() = default;
  virtual Value read(const Block& block, int number, Span span) = 0;
  virtual Value read(const Block& block, std::string_view name, Span span) = 0;
  /// 1 or 0; not known where only the machine knows.
  virtual Value exists(const Block& block, std::string_view name, Span span) = 0;
  virtual ParameterLimits limits() const { return {}; }
};

class Evaluator {
 public:
  /// `equal_within`: of EQ and NE; 1e-4 [LinuxCNC, measured]. `vacant_is_zero`: a variable that was never set counts as
  /// 0; else it is compared with EMPTY alone. `unsourced_refused`: so are ROUND(-2.5) and ATAN2(0,0).
  /// `relative_within`: numbers that are no further apart, of the larger, compare as the same.
  explicit Evaluator(double equal_within = 1e-4, bool vacant_is_zero = true, double doubtful_within = 0,
                     bool unsourced_refused = false, double relative_within = 0)
      : equality_{equal_within, relative_within},
        doubtful_within_(doubtful_within),
        vacant_is_zero_(vacant_is_zero),
        unsourced_refused_(unsourced_refused) {}
  /// The value of the code that begins at `code` in block.code. Refuses what the control would: nc-arithmetic and the
  /// like.
  Value run(const Block& block, std::uint32_t code, ParameterReader& parameters, const Rounding& rounding = {});

 private:
  void check_vacant(const Block& block, const Instruction& step, const Value& a, const Value& b) const;
  static void check_bracketed(const Block& block, const Instruction& step, const Value& a, const Value& b);
  Value joined(const Block& block, const Instruction& step, const Value& a, const Value& b) const;
  Value of_one_operand(const Block& block, const Instruction& step, const Value& b) const;
  bool are_doubtful(const Value& a, const Value& b) const;
  bool is_rounded(const Instruction& step, const Value& result, const Value& a, const Value& b) const;
  void check_digits(const Block& block, const Instruction& step, const Value& a, const Value& b) const;
  void check_whole_digits(const Block& block, const Instruction& step, const Value& value) const;
  Equality equality_;
  double doubtful_within_;
  bool vacant_is_zero_, unsourced_refused_;
  void check_truths(const Block& block, const Instruction& step) const;
  void check_bounds(const Block& block, const Instruction& step) const;
  std::vector<Value> stack_;
};

}  // namespace plumbline::nc
