#include "report/progress_text.hpp"

#include <catch2/catch.hpp>

using plumbline::report::progress_text;
using plumbline::report::wait_text;

TEST_CASE("a wait is said in the two largest units that it has") {
  CHECK(wait_text(0) == "0 s");
  CHECK(wait_text(8.2) == "9 s");
  CHECK(wait_text(125) == "2 min 5 s");
  CHECK(wait_text(3840) == "1 h 4 min");
  CHECK(wait_text(-1) == "0 s");
}

TEST_CASE("progress is a bar, a share, and what is left once that can be told") {
  CHECK(progress_text("check", 1, 4, 1, 80) == "check  [##########------------------------------]   25 %");
  CHECK(progress_text("check", 1, 4, 10, 80) == "check  [##########------------------------------]   25 %, 30 s left");
  CHECK(progress_text("check", 0, 4, 10, 80) == "check  [----------------------------------------]    0 %");
  CHECK(progress_text("check", 5, 4, 10, 80) == "check  [########################################]  100 %, 0 s left");
}

TEST_CASE("progress never says that all is done before it is") {
  CHECK(progress_text("check", 999, 1000, 1, 80).find("100 %") == std::string::npos);
}

TEST_CASE("progress fits the terminal, however narrow") {
  for (std::size_t columns = 5; columns < 120; ++columns) {
    INFO(columns);
    CHECK(progress_text("compensate", 1, 3, 60, columns).size() <= columns);
  }
  CHECK(progress_text("compensate", 1, 3, 60, 40).find("33 %, 2 min 0 s left") != std::string::npos);
  CHECK(progress_text("compensate", 1, 3, 60, 5) == " 33 %");
}
