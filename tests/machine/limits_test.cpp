#include "machine/limits.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

namespace {

Pose<double> tilted(double degrees, double x_mm = 0, double z_mm = -1008) {
  return {{x_mm * kMm, 0, z_mm * kMm}, axis_rotation(0, degrees * kDeg)};
}

}  // namespace

TEST_CASE("tilt is the angle between the Z axes, whatever the turn about Z") {
  const Matrix3<double> R = axis_rotation(0, -0.2) * axis_rotation(2, 1.1);
  CHECK(tilt(R) == Approx(0.2).epsilon(1e-14));
  CHECK(tilt(axis_rotation(1, 1e-9)) == Approx(1e-9).epsilon(1e-6));
}

TEST_CASE("a programmed pose may tilt to the limit, a compensated one a little further") {
  const MachineModel model = pm600_like();
  CHECK(check_programmed(model.limits, tilted(25)).empty());
  CHECK(check_programmed(model.limits, tilted(-25.0000005)).empty());
  const auto broken = check_programmed(model.limits, tilted(25.01));
  REQUIRE(broken.size() == 1);
  CHECK(broken[0].what == "tilt");
  CHECK(broken[0].by_how_much == Approx(0.01));
  CHECK(to_text(broken[0]) == "tilt would be 25.01 deg, 0.01 deg beyond its limit of 25 deg");
  CHECK(check_compensated(model.limits, model.geometry, tilted(25.09)).empty());
  CHECK(check_compensated(model.limits, model.geometry, tilted(25.11)).size() == 1);
}

TEST_CASE("travel, strut lengths and condition are told one by one") {
  MachineModel model = pm600_like();
  CHECK(check_compensated(model.limits, model.geometry, tilted(0, 300)).empty());
  auto broken = check_compensated(model.limits, model.geometry, tilted(0, 300.5));
  REQUIRE(broken.size() == 1);
  CHECK(broken[0].what == "X");
  CHECK(broken[0].value == Approx(300.5));
  CHECK(broken[0].by_how_much == Approx(0.5));

  model.limits.length_max[2] = 1.25;
  broken = check_compensated(model.limits, model.geometry, tilted(0));
  REQUIRE(broken.size() == 1);
  CHECK(broken[0].what == "strut 3");
  CHECK(broken[0].limit == Approx(1250));
  CHECK(broken[0].unit == "mm");

  model = pm600_like();
  model.limits.condition_max = 3;
  broken = check_compensated(model.limits, model.geometry, tilted(0));
  REQUIRE(broken.size() == 1);
  CHECK(broken[0].what == "condition");
}

TEST_CASE("a pose that is no number is within no limit") {
  const MachineModel model = pm600_like();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(check_programmed(model.limits, tilted(nan)).size() == 1);
  const auto broken = check_compensated(model.limits, model.geometry, tilted(0, nan));
  CHECK(broken.size() == 1 + kStruts);  // X and each strut
}
