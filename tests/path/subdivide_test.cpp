#include "path/subdivide.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"

using namespace plumbline;

namespace {

path::Curve line(AxisWords to) {
  nc::Motion motion;
  motion.kind = nc::MotionKind::feed;
  motion.to = to;
  return path::Curve(motion);
}

path::Curve circle(double radius) {
  nc::Motion motion;
  motion.kind = nc::MotionKind::arc;
  motion.from = motion.to = {{radius, 0, 0, 0, 0, 0}};
  motion.arc.turns = 1;
  return path::Curve(motion);
}

int pieces(const path::Curve& curve, path::StepSettings settings = {}) {
  return path::subdivide(curve, std::nullopt, settings).pieces;
}

}  // namespace

TEST_CASE("a piece ends at 1 mm, 0.1 deg of arc or 0.1 deg of tool rotation, whichever comes first") {
  CHECK(pieces(line({{10, 0, 0, 0, 0, 0}})) == 10);
  CHECK(pieces(line({{10.01, 0, 0, 0, 0, 0}})) == 11);
  CHECK(pieces(line({{0.3, 0, 0, 0, 0, 0}})) == 1);
  CHECK(pieces(line({{0, 0, 0, 5, 0, 0}})) == 50);
  CHECK(pieces(line({{1, 0, 0, 0, 0, -5}})) == 50);
  CHECK(pieces(circle(10)) == 3600);    // 0.1 deg
  CHECK(pieces(circle(1000)) == 6284);  // 1 mm
  CHECK(pieces(line({{0, 0, 0, 0, 0, 0}})) == 1);
}

TEST_CASE("the steps are settings") {
  CHECK(pieces(line({{10, 0, 0, 1, 0, 0}}), {.angle_deg = 0.5, .length_mm = 4}) == 3);
  CHECK(pieces(line({{10, 0, 0, 1, 0, 0}}), {.angle_deg = 0.05, .length_mm = 4}) == 20);
}

TEST_CASE("no piece is shorter than the control's time for a block") {
  const path::StepSettings settings{.least_time_s = 0.01};
  const path::Subdivision cut = path::subdivide(line({{10, 0, 0, 0, 0, 0}}), 0.055, settings);
  CHECK(cut.pieces == 5);
  CHECK(cut.widened);
  CHECK_FALSE(path::subdivide(line({{10, 0, 0, 0, 0, 0}}), 1.0, settings).widened);
  CHECK(path::subdivide(line({{10, 0, 0, 0, 0, 0}}), 0.001, settings).pieces == 1);
}

TEST_CASE("a step of next to nothing leaves the least time to decide") {
  const path::StepSettings settings{.length_mm = 1e-320, .least_time_s = 0.01};
  const path::Subdivision cut = path::subdivide(line({{10, 0, 0, 0, 0, 0}}), 0.055, settings);
  CHECK(cut.pieces == 5);
  CHECK(cut.widened);
}

TEST_CASE("a move of absurd length is refused") { CHECK_THROWS_AS(pieces(line({{1e9, 0, 0, 0, 0, 0}})), Refusal); }
