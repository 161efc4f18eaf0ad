#include "measure/tracker.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

const std::string kCommanded = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,";
const std::string kMeasured = "measured_x_mm,measured_y_mm,measured_z_mm";
const std::string kRows =
    "0,100,-1008,-10,0,0,1.5,101.5,-1006\n10,0,-1000,0,5,0,11,1,-999\n"
    "0,0,-900,0,0,0,1,1,-899\n50,50,-1100,3,3,3,51,51,-1099\n";

}  // namespace

TEST_CASE("a tracker's table is read in SI, its columns in any order") {
  const Scratch scratch;
  const measure::TrackedPoses poses =
      measure::read_tracked_poses(scratch.file("t.csv", kCommanded + kMeasured + "\n" + kRows));
  REQUIRE(poses.poses.size() == 4);
  CHECK_FALSE(poses.has_tilt());
  CHECK(poses.poses[0].position_W == Vector3<double>(0, 0.1, -1.008));
  CHECK(poses.poses[0].tilt.x() == Approx(-10 * kDeg));
  CHECK(poses.poses[0].measured.y() == Approx(0.1015));
  CHECK(poses.poses[0].payload_mass == 0);
  CHECK(poses.poses[2].place.line == 4);

  const std::string more = "name,measured_c_deg,measured_b_deg,measured_a_deg,payload_kg," + kMeasured + "," +
                           kCommanded.substr(0, kCommanded.size() - 1) + "\n";
  std::string rows;
  for (int i = 0; i < 4; ++i) rows += "p,3,2,1,20,7,8,9,1,2,3,4,5,6\n";
  const measure::TrackedPoses all = measure::read_tracked_poses(scratch.file("u.csv", more + rows));
  REQUIRE(all.has_tilt());
  CHECK(all.poses[3].measured_tilt->x() == Approx(1 * kDeg));
  CHECK(all.poses[3].payload_mass == 20);
  CHECK(all.poses[3].position_W.z() == Approx(0.003));
}

TEST_CASE("flaws of a tracker's table are refused at their place") {
  const Scratch scratch;
  const auto refused = [&](const std::string& text) {
    return refusal_of([&] { measure::read_tracked_poses(scratch.file("t.csv", text)); });
  };
  CHECK(refused(kCommanded + "measured_x_mm\n").code == "csv-header");
  CHECK(refused(kCommanded + kMeasured + ",measured_a_deg\n").code == "tracker-tilt-part");
  CHECK(refused(kCommanded + kMeasured + "\n0,0,0,0,0,0,1,1,1\n").code == "tracker-too-few");
  const Diagnostic number = refused(kCommanded + kMeasured + "\n" + kRows + "0,0,x,0,0,0,1,1,1\n");
  CHECK(number.code == "csv-number");
  CHECK(number.place.line == 6);
  CHECK(number.place.column == 5);
  CHECK(refused(kCommanded + kMeasured + "\n0,0,0\n").code == "csv-columns");
}
