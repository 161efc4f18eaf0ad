#include "path/curve.hpp"

#include <cmath>

#include <catch2/catch.hpp>

using namespace plumbline;
using nc::Motion;
using nc::MotionKind;

namespace {

Motion line(AxisWords from, AxisWords to) {
  Motion motion;
  motion.kind = MotionKind::feed;
  motion.from = from;
  motion.to = to;
  return motion;
}

Motion arc(AxisWords from, AxisWords to, nc::Plane plane, std::array<double, 3> centre, int turns) {
  Motion motion = line(from, to);
  motion.kind = MotionKind::arc;
  motion.arc = {plane, centre, turns};
  return motion;
}

}  // namespace

TEST_CASE("a line goes straight in all six words and ends where it was told") {
  const path::Curve curve(line({{0, 0, 0, 0, 0, 0}}, {{3, 4, 0, 10, -20, 0.1}}));
  CHECK(curve.linear_mm() == Approx(5));
  CHECK(curve.arc_deg() == 0);
  CHECK(curve.at(0.5)[Axis::B] == Approx(-10));
  CHECK(curve.at(1)[Axis::C] == 0.1);  // not 0.1 give or take a bit
  CHECK(curve.point(0.3).slope[Axis::Y] == 4);
}

TEST_CASE("a quarter circle keeps its radius, and rotary words go linearly with the angle") {
  const path::Curve curve(arc({{10, 0, 5, 0, 0, 0}}, {{0, 10, 5, 9, 0, 0}}, nc::Plane::xy, {0, 0, 5}, 1));
  CHECK(curve.arc_deg() == Approx(90));
  CHECK(curve.linear_mm() == Approx(10 * M_PI / 2));
  for (double f : {0.1, 0.37, 0.5, 0.99}) {
    const AxisWords at = curve.at(f);
    CHECK(std::hypot(at[Axis::X], at[Axis::Y]) == Approx(10).margin(1e-12));
    CHECK(at[Axis::A] == Approx(9 * f));
  }
  CHECK(curve.at(0.5)[Axis::X] == Approx(10 * std::sqrt(0.5)));
  CHECK(curve.point(0).bend[Axis::X] == Approx(-10 * M_PI * M_PI / 4));
  CHECK(curve.point(0).slope[Axis::Y] == Approx(10 * M_PI / 2));
}

TEST_CASE("the sense and the turns of an arc") {
  const AxisWords start{{10, 0, 0, 0, 0, 0}};
  const AxisWords quarter{{0, 10, 0, 0, 0, 0}};
  CHECK(path::Curve(arc(start, quarter, nc::Plane::xy, {}, -1)).arc_deg() == Approx(-270));
  CHECK(path::Curve(arc(start, quarter, nc::Plane::xy, {}, 3)).arc_deg() == Approx(90 + 720));
  CHECK(path::Curve(arc(start, quarter, nc::Plane::xy, {}, -2)).arc_deg() == Approx(-270 - 360));
  CHECK(path::Curve(arc(start, start, nc::Plane::xy, {}, 1)).arc_deg() == Approx(360));
  CHECK(path::Curve(arc(start, start, nc::Plane::xy, {}, -1)).arc_deg() == Approx(-360));
}

TEST_CASE("a circle that begins at half a turn is a full one, whichever side of it rounding put its ends") {
  for (const double start : {-1e-14, -0.0, 0.0, 1e-14}) {
    for (const double end : {-1e-14, -0.0, 0.0, 1e-14}) {
      const AxisWords from{{-10, start, 0, 0, 0, 0}};
      const AxisWords to{{-10, end, 0, 0, 0, 0}};
      CHECK(path::Curve(arc(from, to, nc::Plane::xy, {}, 1)).arc_deg() == Approx(360));
      CHECK(path::Curve(arc(from, to, nc::Plane::xy, {}, -1)).arc_deg() == Approx(-360));
      CHECK(path::Curve(arc(from, to, nc::Plane::xy, {}, 2)).arc_deg() == Approx(720));
    }
  }
}

TEST_CASE("arcs in G18 turn from Z to X and in G19 from Y to Z") {
  // G18, counter-clockwise seen against Y: from +Z to +X.
  const path::Curve zx(arc({{0, 0, 10, 0, 0, 0}}, {{10, 2, 0, 0, 0, 0}}, nc::Plane::zx, {0, 0, 0}, 1));
  CHECK(zx.arc_deg() == Approx(90));
  CHECK(zx.at(0.5)[Axis::X] == Approx(10 * std::sqrt(0.5)));
  CHECK(zx.at(0.5)[Axis::Y] == Approx(1));  // helix
  const path::Curve yz(arc({{0, 10, 0, 0, 0, 0}}, {{0, 0, 10, 0, 0, 0}}, nc::Plane::yz, {0, 0, 0}, 1));
  CHECK(yz.arc_deg() == Approx(90));
  CHECK(yz.at(0.5)[Axis::Z] == Approx(10 * std::sqrt(0.5)));
}

TEST_CASE("slope and bend of an arc are the derivatives of its position") {
  const path::Curve curve(arc({{10, 0, 0, 1, 2, 3}}, {{0, 10.001, 4, -5, 6, 7}}, nc::Plane::xy, {0, 0, 0}, 2));
  const double h = 1e-6;
  for (double f : {0.1, 0.5, 0.9}) {
    const AxisWords difference = curve.at(f + h) - curve.at(f - h);
    const path::CurvePoint point = curve.point(f);
    const AxisWords turned = curve.point(f + h).slope - curve.point(f - h).slope;
    for (const Axis axis : kAllAxes) {
      CHECK(point.at[axis] == curve.at(f)[axis]);
      CHECK(point.slope[axis] == Approx(difference[axis] / (2 * h)).epsilon(1e-7));
      CHECK(point.bend[axis] == Approx(turned[axis] / (2 * h)).epsilon(1e-7).margin(1e-6));
    }
  }
}
