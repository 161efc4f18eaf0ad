#include "nc/control/state/arc_shape.hpp"

#include <numbers>

#include <catch2/catch.hpp>

using namespace plumbline;
using namespace plumbline::nc;

namespace {

AxisWords at(double x, double y, double z) { return {{x, y, z, 0, 0, 0}}; }

}  // namespace

TEST_CASE("an arc sweeps from its start to its end about its centre, with its turns") {
  const ArcShape quarter = arc_shape(at(10, 0, 1), at(0, 10, 4), {Plane::xy, {0, 0, 0}, 1});
  CHECK(quarter.sweep == Approx(std::numbers::pi / 2));
  CHECK(quarter.circle_mm() == Approx(5 * std::numbers::pi));
  CHECK(quarter.length_mm() == Approx(std::hypot(5 * std::numbers::pi, 3)));
  CHECK(arc_shape(at(10, 0, 0), at(0, 10, 0), {Plane::xy, {0, 0, 0}, -1}).sweep == Approx(-1.5 * std::numbers::pi));
  CHECK(arc_shape(at(10, 0, 0), at(0, 10, 0), {Plane::xy, {0, 0, 0}, 3}).sweep == Approx(4.5 * std::numbers::pi));
  CHECK(arc_shape(at(10, 0, 0), at(10, 0, 0), {Plane::xy, {0, 0, 0}, 1}).sweep == Approx(2 * std::numbers::pi));
  const ArcShape in_zx = arc_shape(at(0, 2, 10), at(10.5, 3, 0), {Plane::zx, {0, 0, 0}, 1});
  CHECK(in_zx.sweep == Approx(std::numbers::pi / 2));
  CHECK(in_zx.start_radius == Approx(10));
  CHECK(in_zx.end_radius == Approx(10.5));
  CHECK(in_zx.rise_mm == Approx(1));
}

TEST_CASE("a control takes a spiral that is small, or small against its radius") {
  CHECK(radii_agree(1, 1.028, false));
  CHECK_FALSE(radii_agree(1, 1.029, false));
  CHECK(radii_agree(100, 100.09, false));
  CHECK_FALSE(radii_agree(100, 100.11, false));
  CHECK_FALSE(radii_agree(10000, 10003, false));
  CHECK(radii_agree(1, 1.07, true));
  CHECK(radii_agree(5, 5 + spiral_taken(true), true));
}
