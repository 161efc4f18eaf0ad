#include "machine/inverse.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

TEST_CASE("struts reach from base joints to platform joints") {
  Random random(3);
  for (const MachineModel& model : three_machines()) {
    const Geometry tool = with_tool(model.geometry, 0.12);
    const Pose<double> pose = pose_within(model.limits, random);
    const StrutGeometry<double> struts = strut_geometry(tool, pose);
    for (int j = 0; j < kStruts; ++j) {
      const Vector3<double> platform_joint =
          pose.p_WT + pose.R_WP * (model.geometry.platform_joints_P.col(j) - model.geometry.tool_tip_P +
                                   Vector3<double>(0, 0, 0.12));
      const Vector3<double> reached = model.geometry.base_joints_W.col(j) + struts.length[j] * struts.direction.col(j);
      CHECK((reached - platform_joint).norm() < 1e-15 * 4);
      CHECK(std::abs(struts.direction.col(j).norm() - 1) < 1e-15);
    }
    CHECK(strut_lengths(tool, pose) == struts.length);
  }
}

TEST_CASE("a vertical strut over its base joint is as long as the height") {
  Geometry geometry;
  geometry.platform_joints_P.row(2).setConstant(0.25);
  Pose<double> pose;
  pose.p_WT = {0, 0, -1};
  CHECK(strut_lengths(geometry, pose)[0] == 0.75);
}
