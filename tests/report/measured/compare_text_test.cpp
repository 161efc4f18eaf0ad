#include "report/measured/compare_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace plumbline;

namespace {

// One run with both, one with readings of the bar alone.
jobs::Comparison two_runs() {
  jobs::Comparison all;
  all.radial_rms_um = 1.25;
  all.torque_rms_Nm = 0.0625;
  all.torque_mean_abs_Nm = {0.01, 0.02, 0.03, 0.04, 0.05, 0.06};
  all.runs.push_back({"first", 0.5, 0.0625, {0.01, 0.02, 0.03, 0.04, 0.05, 0.06}, {1.5, -2, 0}, 3.25});
  all.runs.push_back({"bar alone", 2, {}, {}, {0, 0, 4}, 0});
  return all;
}

}  // namespace

TEST_CASE("a comparison is a line a run, and what was not measured a dash") {
  CHECK(report::compare_text(two_runs()) ==
        "run                      radial rms um torque rms Nm   ball off by x, y, z and bar (um)\n"
        "first                            0.500        0.0625   1.5, -2.0, 0.0, 3.2\n"
        "bar alone                        2.000             -   0.0, 0.0, 4.0, 0.0\n"
        "all                              1.250        0.0625\n"
        "mean absolute torque error per strut (N m): 0.0100, 0.0200, 0.0300, 0.0400, 0.0500, 0.0600\n");
}

TEST_CASE("without torques, and without the bar, nothing is said of them") {
  jobs::Comparison bar = two_runs();
  bar.torque_rms_Nm = {};
  CHECK(report::compare_text(bar).find("mean absolute") == std::string::npos);
  jobs::Comparison torques;
  torques.torque_rms_Nm = 0.5;
  torques.runs.push_back({"torques", {}, 0.5, {}, {}, 0});
  const std::string text = report::compare_text(torques);
  CHECK(text.find("\ntorques                              -        0.5000\n") != std::string::npos);
  CHECK(text.find("\nall                                  -        0.5000\n") != std::string::npos);
}

TEST_CASE("a comparison as JSON has null for what was not measured") {
  const nlohmann::json json = nlohmann::json::parse(report::compare_json(two_runs()));
  CHECK(json["radial_rms_um"] == 1.25);
  CHECK(json["torque_mean_abs_Nm"].size() == 6);
  CHECK(json["runs"][0]["setup"] == nlohmann::json{{"ball_um", {1.5, -2.0, 0.0}}, {"bar_um", 3.25}});
  CHECK(json["runs"][1]["id"] == "bar alone");
  CHECK(json["runs"][1]["torque_rms_Nm"].is_null());
}
