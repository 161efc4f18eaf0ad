#include "machine/condition.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

TEST_CASE("the condition number does not depend on the unit of length, and the bound encloses it") {
  Random random(8);
  for (const MachineModel& model : three_machines()) {
    Geometry large = model.geometry;
    large.base_joints_W *= 1000;
    large.platform_joints_P *= 1000;
    large.tool_tip_P *= 1000;
    for (int n = 0; n < 100; ++n) {
      Pose<double> pose = pose_within(model.limits, random);
      const StrutGeometry<double> struts = strut_geometry(model.geometry, pose);
      const double radius = platform_radius(model.geometry);
      const double condition = condition_number(struts, radius);
      const double bound = condition_bound(struts, radius);
      CHECK(condition > 1);
      CHECK(bound >= condition * (1 - 1e-9));
      CHECK(bound <= 6 * condition * (1 + 1e-9));
      pose.p_WT *= 1000;
      CHECK(condition_number(strut_geometry(large, pose), platform_radius(large)) == Approx(condition).epsilon(1e-9));
    }
  }
}

TEST_CASE("parallel struts are singular") {
  Geometry geometry = pm600_like().geometry;
  geometry.base_joints_W = geometry.platform_joints_P;
  Pose<double> pose;
  pose.p_WT = {0, 0, -1};
  const StrutGeometry<double> struts = strut_geometry(geometry, pose);
  CHECK(condition_number(struts, 0.1) > 1e12);
  CHECK(condition_bound(struts, 0.1) > 1e12);
}

TEST_CASE("that the condition number is below another is proved where it is, and by little as well") {
  Random random(31);
  for (const MachineModel& model : three_machines()) {
    const double radius = platform_radius(model.geometry);
    int proved = 0;
    for (int n = 0; n < 500; ++n) {
      const auto struts = strut_geometry(model.geometry, pose_within(model.limits, random));
      const double number = condition_number(struts, radius);
      if (number > 1e5) continue;
      ++proved;
      CHECK_FALSE(condition_surely_below(struts, radius, number * (1 - 1e-9)));
      CHECK(condition_surely_below(struts, radius, 1.03 * number));
      CHECK_FALSE(condition_surely_below(struts, radius, 0));
    }
    CHECK(proved > 400);
  }
  StrutGeometry<double> flat = strut_geometry(pm600_like().geometry, home_pose(pm600_like()));
  flat.direction.col(1) = flat.direction.col(0);
  flat.arm.col(1) = flat.arm.col(0);
  CHECK_FALSE(condition_surely_below(flat, 0.1, 1e9));
}
