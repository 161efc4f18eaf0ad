#include "report/measured/where_json.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include "support/diagnosis.hpp"

using namespace plumbline;
using Json = nlohmann::json;

TEST_CASE("a number has six digits, and null stands for what is none") {
  CHECK(report::rounded(1.0 / 3) == 0.333333);
  CHECK(report::rounded(-1234567.8) == -1234570.0);
  CHECK(report::rounded(0.1 + 0.2) == 0.3);
  CHECK(report::rounded(std::numeric_limits<double>::infinity()).is_null());
  CHECK(report::rounded(std::numeric_limits<double>::quiet_NaN()).is_null());
}

TEST_CASE("where the gap is, in um for the bar and in N m for torques") {
  diagnose::GapMap map = testing::small_diagnosis().gap_map;
  diagnose::ChannelResiduals torque{2, 0.06};
  torque.arcs[11] = 0.5;
  map.channels.push_back(torque);
  const Json where = report::where_json(map);
  const Json& bar = where["channels"][0];
  CHECK(bar["rms"] == 3.1);
  CHECK(bar["arcs_rms"].size() == 12);
  CHECK(bar["arcs_rms"][3] == 5.0);
  CHECK(bar["harmonics_rms"][1] == 1.0);
  CHECK(bar["harmonics_noise"] == Json(std::vector<double>(10, 0.1)));
  CHECK(where["channels"][1]["channel"] == "torque2_Nm");
  CHECK(where["channels"][1]["arcs_rms"][11] == 0.5);
}

TEST_CASE("pairs, groups and reversals say what they are by") {
  diagnose::GapMap map = testing::small_diagnosis().gap_map;
  map.contrasts[0].radial.correlation = -0.75;
  map.groups.push_back({diagnose::Grouping::start, 1.5, 3, 4, {1e-6, 0.5}});
  const Json where = report::where_json(map);
  CHECK(where["contrasts"][0] == Json{{"by", "direction"},
                                      {"pairs", 2},
                                      {"common_rms", {{"radial_um", 0.5}, {"torque_Nm", 0.05}}},
                                      {"differs_rms", {{"radial_um", 2.0}, {"torque_Nm", 0.1}}},
                                      {"correlation", {{"radial", -0.75}, {"torque", 0.0}}}});
  CHECK(where["groups"][0]["by"] == "tilt_deg");
  CHECK(where["groups"][1] == Json{{"by", "start_h"},
                                   {"from", 1.5},
                                   {"to", 3.0},
                                   {"runs", 4},
                                   {"rms", {{"radial_um", 1.0}, {"torque_Nm", 0.5}}}});
  CHECK(where["reversals"][0] == Json{{"strut", 1},
                                      {"count", 6},
                                      {"length_um", 4.0},
                                      {"length_standard_error_um", 0.5},
                                      {"torque_Nm", nullptr},
                                      {"torque_standard_error_Nm", nullptr}});
}

TEST_CASE("circularity of runs is the mean and the largest of those that have any") {
  std::vector<diagnose::RunGap> runs(3);
  runs[0].circularity = diagnose::Circularity{20e-6, 9e-6, 4e-6};
  runs[2].circularity = diagnose::Circularity{10e-6, 11e-6, 2e-6};
  const report::CircularityOfRuns all = report::circularity_of(runs);
  CHECK(all.runs == 2);
  CHECK(Json(report::circularity_json(all)) == Json{{"measured", {{"mean", 15.0}, {"largest", 20.0}}},
                                                    {"compensated_with_given", {{"mean", 10.0}, {"largest", 11.0}}},
                                                    {"compensated_with_found", {{"mean", 3.0}, {"largest", 4.0}}}});
  CHECK(report::circularity_json(report::circularity_of({})).is_null());
}
