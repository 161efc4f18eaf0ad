#include "path/duration.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;

namespace {

nc::Dialect rs274() {
  nc::Dialect dialect;
  dialect.name = "test";
  dialect.feed_rule = nc::FeedRule::xyz_first;
  dialect.feed_rate_min = 0.1;
  return dialect;
}

nc::Motion feed(AxisWords to, double f, nc::FeedMode mode = nc::FeedMode::per_minute) {
  nc::Motion motion;
  motion.kind = nc::MotionKind::feed;
  motion.to = to;
  motion.feed = f;
  motion.feed_mode = mode;
  return motion;
}

std::optional<double> seconds(nc::Motion motion, const nc::Dialect& dialect = rs274()) {
  motion.feed_rule = dialect.feed_rule;
  return path::duration(motion, path::Curve(motion), dialect);
}

}  // namespace

TEST_CASE("a feed per minute is the speed of X Y Z if any of them moves, else of A B C") {
  CHECK(seconds(feed({{30, 40, 0, 0, 0, 0}}, 100)).value() == Approx(30));
  CHECK(seconds(feed({{30, 40, 0, 90, 0, 0}}, 100)).value() == Approx(30));
  CHECK(seconds(feed({{0, 0, 0, 3, 4, 0}}, 10)).value() == Approx(30));
}

TEST_CASE("other controls count degrees as millimetres, or do not say") {
  nc::Dialect dialect = rs274();
  dialect.feed_rule = nc::FeedRule::all_axes_as_mm;
  CHECK(seconds(feed({{3, 0, 0, 4, 0, 0}}, 60), dialect).value() == Approx(5));
  dialect.feed_rule = nc::FeedRule::unknown;
  CHECK_FALSE(seconds(feed({{3, 0, 0, 4, 0, 0}}, 60), dialect).has_value());
  CHECK(seconds(feed({{3, 0, 0, 0, 0, 0}}, 60), dialect).value() == Approx(3));
}

TEST_CASE("inverse time is the time, but for the least rate of the control") {
  CHECK(seconds(feed({{1, 0, 0, 0, 0, 0}}, 2, nc::FeedMode::inverse_time)).value() == Approx(30));
  // 0.001 mm x 10/min = 0.01 mm/min is lifted to 0.1 mm/min: 0.6 s instead of 6 s
  CHECK(seconds(feed({{0.001, 0, 0, 0, 0, 0}}, 10, nc::FeedMode::inverse_time)).value() == Approx(0.6));
  nc::Motion inches = feed({{0.001, 0, 0, 0, 0, 0}}, 10, nc::FeedMode::inverse_time);
  inches.mm_per_unit = 25.4;
  CHECK(seconds(inches).value() == Approx(0.6 / 25.4));
}

TEST_CASE("no time is made up where the program sets none") {
  CHECK_FALSE(seconds(feed({{1, 0, 0, 0, 0, 0}}, 0)).has_value());
  nc::Motion rapid = feed({{1, 0, 0, 0, 0, 0}}, 100);
  rapid.kind = nc::MotionKind::rapid;
  CHECK_FALSE(seconds(rapid).has_value());
}

TEST_CASE("under G95 the unit is revolutions") {
  CHECK(seconds(feed({{5, 0, 0, 0, 0, 0}}, 0.1, nc::FeedMode::per_revolution)).value() == Approx(50));
}
