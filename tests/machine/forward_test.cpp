#include "machine/forward.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "machine/forward_statistics.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

namespace {

double distance(const Pose<double>& a, const Pose<double>& b) { return displacement_between(a, b).norm(); }

void check_statistics(int poses) {
  for (const MachineModel& model : three_machines()) {
    const ForwardStatistics found = forward_statistics(model, poses, 9);
    INFO(model.name << ": " << to_text(found));
    CHECK(found.within_six >= 0.99 * poses);
    CHECK(found.within_twelve >= 0.999 * poses);
    CHECK(found.within_twelve + found.stated == poses);
    CHECK(found.wrong_side == 0);
    CHECK(found.worst_residual_m <= 1e-12);
  }
}

}  // namespace

TEST_CASE("from 50 mm and 10 deg away the pose is found in a few steps, or the failure is stated") {
  check_statistics(20000);
}

TEST_CASE("the same of 200,000 poses of each machine", "[.][slow]") { check_statistics(200000); }

TEST_CASE("lengths that no pose has are stated, not met") {
  const MachineModel model = pm600_like();
  const Pose<double> home = home_pose(model);
  PerStrut<double> lengths = strut_lengths(model.geometry, home);
  lengths[0] *= 3;
  const ForwardResult result = forward(model.geometry, lengths, home, {.most_iterations = 50});
  CHECK_FALSE(result.converged());
  CHECK(result.residual_m > 1e-3);
  CHECK_FALSE(to_text(result.stopped_because).empty());
}

TEST_CASE("a start on the other side of a singularity is stated") {
  const MachineModel model = pm600_like();
  const Pose<double> home = home_pose(model);
  const int side = side_of(model.geometry, home);
  REQUIRE(side != 0);
  const PerStrut<double> lengths = strut_lengths(model.geometry, home);
  CHECK(forward(model.geometry, lengths, home, {.side = -side}).stopped_because == ForwardStop::wrong_side);
  Geometry flat = model.geometry;
  flat.base_joints_W = flat.platform_joints_P;
  CHECK(side_of(flat, home) == 0);
  CHECK(forward(flat, lengths, home).stopped_because == ForwardStop::singular);
}

TEST_CASE("a length that is no number is met by no pose") {
  const MachineModel model = pm600_like();
  const Pose<double> home = home_pose(model);
  for (int j = 0; j < kStruts; ++j) {
    PerStrut<double> lengths = strut_lengths(model.geometry, home);
    lengths[j] = std::numeric_limits<double>::quiet_NaN();
    const ForwardResult result = forward(model.geometry, lengths, home);
    CHECK_FALSE(result.converged());
    CHECK(std::isnan(result.residual_m));
  }
}

TEST_CASE("from a singular start the second one serves, and says which side is meant") {
  const MachineModel model = pm600_like();
  const Pose<double> home = home_pose(model);
  const int side = side_of(model.geometry, home);
  Pose<double> singular = home;
  double low = 0;
  double high = 120 * kDeg;
  for (int n = 0; n < 100 && side_of(model.geometry, singular) != 0; ++n) {  // turned about Z until J loses its rank
    const double middle = (low + high) / 2;
    singular.R_WP = axis_rotation(2, middle);
    (side_of(model.geometry, singular) == side ? low : high) = middle;
  }
  REQUIRE(side_of(model.geometry, singular) == 0);
  const PerStrut<double> lengths = strut_lengths(model.geometry, home);
  CHECK(forward(model.geometry, lengths, singular).stopped_because == ForwardStop::singular);
  const ForwardResult result =
      forward(model.geometry, lengths, singular, {.most_iterations = 50, .second_start = home});
  CHECK(result.converged());
  CHECK(side_of(model.geometry, result.pose) == side);
}

TEST_CASE("small changes of the lengths are followed by the chord method, one pose or a pack of them") {
  Random random(10);
  for (const MachineModel& model : three_machines()) {
    for (int n = 0; n < 300; ++n) {
      const Pose<double> pose = pose_within(model.limits, random);
      const StrutGeometry<double> struts = strut_geometry(model.geometry, pose);
      const Matrix6<double> J = jacobian(struts);
      const Lu6<double> lu(J);
      if (condition_of(model, struts) > 100) continue;
      const PerStrut<double> change = PerStrut<double>::NullaryExpr([&] { return uniform(random, -50e-6, 50e-6); });
      const auto result = forward_near<double>(model.geometry, pose, struts, lu, change);
      CHECK(result.converged);
      CHECK(result.iterations <= 6);
      CHECK((strut_lengths(model.geometry, result.pose) - struts.length - change).cwiseAbs().maxCoeff() <= 1e-12);
      const ForwardResult full = forward(model.geometry, struts.length + change, pose);
      CHECK(full.converged());
      CHECK(distance(full.pose, result.pose) < 1e-10);

      const Pose<Pack> poses{pose.p_WT.cast<Pack>(), pose.R_WP.cast<Pack>()};
      const auto at = strut_geometry(model.geometry, poses);
      const auto packed = forward_near<Pack>(model.geometry, poses, at, Lu6<Pack>(jacobian(at)), change.cast<Pack>());
      CHECK(all(packed.converged));
      CHECK(std::abs(packed.pose.p_WT[2][0] - result.pose.p_WT[2]) < 1e-12);
    }
  }
}
