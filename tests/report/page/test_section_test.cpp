#include "report/page/test_section.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

namespace plumbline::report {
namespace {

TEST_CASE("a test is drawn where the machine stands as its turn begins") {
  const machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  ShownTest test{"next", {}, "why", "G0 X1"};
  test.run.centre_W = {0.1, -0.05, -1};
  test.run.radius = 0.144;
  test.run.bar = 0.15;
  test.run.feed = 1000 * kMmPerMin;
  const Json json = tests_section("The next test", machine, {test});
  CHECK(json["type"] == "circles");
  CHECK(json["machine"]["base_mm"].size() == 6);
  CHECK(json["machine"]["limits_mm"]["x"] == Json{-300.0, 300.0});
  const Json& one = json["tests"][0];
  CHECK(one["start_mm"][0].get<double>() == Approx(244));
  CHECK(one["bar_mm"].get<double>() == Approx(150));
  CHECK(one["program"] == "G0 X1");
  // not tilted: joints stand where the model has them, from the tip
  const Vector3<double> joint = test.run.centre_W + Vector3<double>(0.144, 0, 0) +
                                machine.geometry.platform_joints_P.col(2) - machine.geometry.tool_tip_P;
  for (int k = 0; k < 3; ++k) {
    CHECK(one["platform_mm"][2][static_cast<std::size_t>(k)].get<double>() == Approx(joint[k] / kMm));
  }
}

TEST_CASE("a tilted platform turns about the tip") {
  const machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  ShownTest test{"tilted", {}, "", ""};
  test.run.centre_W = {0, 0, -1};
  test.run.radius = 0.1;
  test.run.tilt = {0, 10 * kDeg, 0};
  const Json json = tests_section("t", machine, {test})["tests"][0];
  CHECK(json["bar_mm"].is_null());
  CHECK_FALSE(json.contains("program"));
  const Vector3<double> from_tip = machine.geometry.platform_joints_P.col(0) - machine.geometry.tool_tip_P;
  const double x = 0.1 + std::cos(10 * kDeg) * from_tip.x() + std::sin(10 * kDeg) * from_tip.z();  // about Y
  CHECK(json["platform_mm"][0][0].get<double>() == Approx(x / kMm));
}

}  // namespace
}  // namespace plumbline::report
