#include "report/text_table.hpp"

#include <catch2/catch.hpp>

using namespace plumbline::report;

TEST_CASE("times are written as people read them") {
  CHECK(time_text(0) == "0.00 s");
  CHECK(time_text(3.416) == "3.42 s");
  CHECK(time_text(59.999) == "1 min 00.0 s");
  CHECK(time_text(754.35) == "12 min 34.4 s");
  CHECK(time_text(3723.4) == "1 h 02 min 03.4 s");
}

TEST_CASE("counts have their thousands apart") {
  CHECK(count_text(0) == "0");
  CHECK(count_text(999) == "999");
  CHECK(count_text(1000) == "1,000");
  CHECK(count_text(12345678) == "12,345,678");
  CHECK(count_text(0, "pose") == "0 poses");
  CHECK(count_text(1, "pose") == "1 pose");
  CHECK(count_text(2000, "pose") == "2,000 poses");
}
