#include "nc/control/parameters/whole_numbers.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;

namespace {

std::string code_of_number(double number, bool known = true) {
  return testing::refusal_of([&] { parameter_number(Block{}, {}, {number, known}); }).code;
}

}  // namespace

TEST_CASE("numbers of parameters are whole and within their limits") {
  CHECK(whole_number(Block{}, {}, 2.00009, "it") == 2);
  CHECK(whole_number(Block{}, {}, -3.00009, "it") == -3);
  CHECK(testing::refusal_of([] { whole_number(Block{}, {}, 2.0002, "it"); }).code == "nc-not-whole");
  CHECK(testing::refusal_of([] { whole_number(Block{}, {}, 2e9, "it"); }).code == "nc-not-whole");
  CHECK(parameter_number(Block{}, {}, {kLastParameter, true}) == kLastParameter);
  CHECK(code_of_number(0) == "nc-parameter-number");
  CHECK(code_of_number(kLastParameter + 1) == "nc-parameter-number");
  CHECK(code_of_number(1, false) == "nc-value-unknown");
  CHECK(parameter_number(Block{}, {}, {0, true}, {.first = 0, .last = 9}) == 0);
}

TEST_CASE("halves below zero, and what misses one above it by its last digits, are left open, and no other number") {
  for (const double number : {0.5, 2.5, -2.4, -2.6, 0.0, -3.0, 0.49999, 2.50000000001, 3.0})
    check_half(Block{}, {}, {number, true});
  check_half(Block{}, {}, {-2.5, false});
  for (const double number : {-0.5, -2.5, -100.5, 0.7 - 0.2, 2.49999999999, 2.3 - 0.8, -0.7 + 0.2, -2.50000000001}) {
    CHECK(testing::refusal_of([&] { check_half(Block{}, {}, {number, true}); }).code == "nc-not-interpreted");
  }
}
