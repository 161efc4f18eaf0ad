#include "base/text/number_text.hpp"

#include <catch2/catch.hpp>

#include "base/check.hpp"

using namespace plumbline;

TEST_CASE("decimals are rounded, trimmed and never written as minus zero") {
  CHECK(to_decimal(1.5, 4) == "1.5");
  CHECK(to_decimal(1.5, 4, 3) == "1.500");
  CHECK(to_decimal(0.00004, 4) == "0");
  CHECK(to_decimal(-0.00004, 4) == "0");
  CHECK(to_decimal(-0.00004, 4, 1) == "0.0");
  CHECK(to_decimal(-0.00005, 4) == "-0.0001");
  CHECK(to_decimal(12.34567, 4) == "12.3457");
  CHECK(to_decimal(-1008, 4) == "-1008");
  CHECK(to_decimal(0.05, 2) == "0.05");
  CHECK(to_decimal(1234567.123456789, 9) == "1234567.123456789");
}

TEST_CASE("ticks and numbers go back and forth without loss") {
  for (const double value : {0.0, 0.1, -0.3, 99.9999, -1008.0, 360.12345}) {
    CHECK(from_ticks(to_ticks(value, 5), 5) == value);
  }
  CHECK_THROWS_AS(to_ticks(1e15, 9), InternalError);
  CHECK_THROWS_AS(to_ticks(1, 12), InternalError);
}

TEST_CASE("numbers are read whole or not at all") {
  CHECK(parse_number("1.5").value() == 1.5);
  CHECK(parse_number("+.5").value() == 0.5);
  CHECK(parse_number("-2").value() == -2);
  CHECK(parse_number("1e3").value() == 1000);
  for (const char* bad : {"", "+", "+-1", "1,5", "1.5 ", "nan", "inf", "0x10", "1e999"}) {
    INFO(bad);
    CHECK_FALSE(parse_number(bad).has_value());
  }
}
