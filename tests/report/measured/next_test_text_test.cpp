#include "report/measured/next_test_text.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"

using namespace plumbline;

namespace {

diagnose::Separation a_circle() {
  measure::Run run;
  run.centre_W = {100 * kMm, -50 * kMm, -1000 * kMm};
  run.tilt = {12.5 * kDeg, -3 * kDeg, 0};
  run.direction = measure::Direction::cw;
  run.feed = 1000 * kMmPerMin;
  return {"cyclic", diagnose::NextTest{run, 7.4}};
}

}  // namespace

TEST_CASE("the next test is one sentence that can be set up") {
  CHECK(report::next_test_text(a_circle()) ==
        "next test, to separate it from cyclic (by 7 sigma): centre 100, -50, -1000 mm, A 12.5 B -3.0 deg, cw, F1000");
}

TEST_CASE("a payload is named where one is to be hung") {
  diagnose::Separation separation = a_circle();
  separation.test->run.payload_mass = 20;
  CHECK(report::next_test_text(separation).ends_with(", cw, F1000, 20 kg at the tip"));
  separation.test->run.direction = measure::Direction::ccw;
  CHECK(report::next_test_text(separation).find(" deg, ccw, F1000, ") != std::string::npos);
}

TEST_CASE("where no test tells two effects apart that is said") {
  CHECK(report::next_test_text({"cable", {}}) == "no circular test separates it from cable");
  CHECK(report::kNats.starts_with("nats are natural logarithms of odds"));  // exp 7 is 1097
}
