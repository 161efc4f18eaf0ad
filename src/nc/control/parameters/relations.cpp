#include "nc/control/parameters/relations.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

constexpr double kUnclear = 0.01;  // of what is allowed for: by which of two formulas it is was found in no source,
constexpr double kNearZero = 10;   // nor what is relative to numbers as small as some times it

bool holds(Operation relation, double a, double b, double equal_within) {
  switch (relation) {
    case Operation::equal:
      return a == b || std::abs(a - b) < equal_within;
    case Operation::not_equal:
      return a != b && std::abs(a - b) >= equal_within;
    case Operation::greater:
      return a > b;
    case Operation::greater_equal:
      return a >= b;
    case Operation::less:
      return a < b;
    case Operation::less_equal:
      return a <= b;
    default:
      break;
  }
  PLUMBLINE_CHECK(false);
  return false;
}

}  // namespace

bool compares(const Block& block, const Instruction& relation, double a, double b, const Equality& equality) {
  const bool as_they_are = holds(relation.operation, a, b, equality.within);
  const double larger = std::max(std::abs(a), std::abs(b));
  const double apart = std::abs(a - b);
  const double allowed = equality.relative_within;
  if (allowed <= 0 || a == b || !std::isfinite(apart)) return as_they_are;
  const bool if_same = holds(relation.operation, a, a, equality.within);
  if (if_same == as_they_are) return as_they_are;
  const bool is_same = apart <= allowed * larger;
  const bool is_unclear = larger <= kNearZero * allowed || std::abs(apart / larger - allowed) <= kUnclear * allowed;
  const bool by_machine = relation.operation == Operation::greater || relation.operation == Operation::less;
  if (is_unclear || (is_same && by_machine)) {
    refuse_at(block, relation.span, codes::kNotInterpreted,
              fmt::format("{:.6g} and what it is compared with are the same but for the last digits: {}", a,
                          by_machine ? "whether > and < take them for equal is set in the machine (MD10280)"
                                     : "whether the control takes them for equal was found in no source"),
              "compare with a number that lies between two values, as 0.95 where steps of 0.1 go to 1, or count by "
              "whole numbers");
  }
  return is_same ? if_same : as_they_are;
}

}  // namespace plumbline::nc
