#include "nc/control/parameters/relations.hpp"

#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/language/refusal.hpp"

using namespace plumbline;
using namespace plumbline::nc;

namespace {

// Nothing: refused.
std::optional<bool> said(Operation operation, double a, double b, const Equality& equality) {
  Block block;
  block.text = "IF";
  Instruction relation;
  relation.operation = operation;
  try {
    return compares(block, relation, a, b, equality);
  } catch (const Refusal&) {
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("EQ and NE take numbers for the same that are less apart than a control allows, the others do not") {
  const Equality near{1e-4, 0};
  CHECK(said(Operation::equal, 1, 1.00009, near) == true);
  CHECK(said(Operation::not_equal, 1, 1.00009, near) == false);
  CHECK(said(Operation::equal, 1, 1.00011, near) == false);
  CHECK(said(Operation::greater, 1.00009, 1, near) == true);
  CHECK(said(Operation::less_equal, 1.00009, 1, near) == false);
}

TEST_CASE("a relative equality is of the larger number, and refused where it is not clear") {
  const Equality relative{0, 1e-12};
  const double sum = 0.1 + 0.2;
  CHECK(said(Operation::equal, sum, 0.3, relative) == true);
  CHECK(said(Operation::not_equal, sum, 0.3, relative) == false);
  CHECK(said(Operation::less_equal, sum, 0.3, relative) == true);
  CHECK(said(Operation::greater_equal, 0.3, sum, relative) == true);
  CHECK(said(Operation::greater_equal, sum, 0.3, relative) == true);
  CHECK(said(Operation::less, sum, 0.3, relative) == false);
  CHECK_FALSE(said(Operation::greater, sum, 0.3, relative).has_value());  // MD10280
  CHECK_FALSE(said(Operation::less, 0.3, sum, relative).has_value());
  CHECK(said(Operation::equal, 9e6, 9e6 + 1e-3, relative) == false);
  CHECK(said(Operation::equal, 9e9, 9e9 + 1e-3, relative) == true);
  CHECK_FALSE(said(Operation::equal, 1, 1 + 1e-12, relative).has_value());
  CHECK_FALSE(said(Operation::equal, 0, 5e-17, relative).has_value());
  CHECK(said(Operation::equal, 0, 1e-9, relative) == false);
  CHECK(said(Operation::equal, 0, 0, relative) == true);
  CHECK(said(Operation::greater, 2, 1, relative) == true);
}
