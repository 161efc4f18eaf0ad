#include "report/page/where_sections.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "support/diagnosis.hpp"
#include "support/page_sections.hpp"

namespace plumbline::report {
namespace {

TEST_CASE("the gap map has each run's channels in units of the noise, before and after") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  const double none = std::nan("");
  Json map = gap_map_section(d);
  CHECK(map["rows"]["labels"] == Json{"first", "<last> & \"best\" (left out)"});
  CHECK(map["columns"]["labels"][0] == "bar");
  CHECK(map["columns"]["labels"][6] == "motor 6");
  REQUIRE(map["figures"].size() == 2);
  const std::vector<double> row{6.2, 1.2, none, none, none, none, none};
  std::vector<double> both = row;
  both.insert(both.end(), row.begin(), row.end());
  CHECK(map["figures"][0]["name"] == "before");
  CHECK(map["figures"][0]["planes"][0]["values"] == packed(both, 1e-3));
  CHECK(map["figures"][0]["planes"][0]["reasons"]["2"] == 0);
  CHECK(map["reasons"][0] == "not measured");
  d.runner_up = "cyclic";
  CHECK(gap_map_section(d)["figures"][2]["name"] == "with cyclic");
}

TEST_CASE("waves and arcs are in units of the noise") {
  const std::vector<Json> sections = around_circle_sections(testing::small_diagnosis());
  REQUIRE(sections.size() == 2);
  std::vector<double> waves(diagnose::kWaves, 0);
  waves[1] = 10;
  std::vector<double> arcs(diagnose::kArcs, 0);
  arcs[3] = 10;
  CHECK(sections[0]["figures"][0]["planes"][0]["values"] == packed(waves, 1e-3));
  CHECK(sections[1]["figures"][0]["planes"][0]["values"] == packed(arcs, 1e-3));
  CHECK(sections[1]["columns"]["values"][3] == 90);
  CHECK(sections[0]["rows"]["labels"] == Json{"bar"});
  diagnose::Diagnosis nothing = testing::small_diagnosis();
  nothing.gap_map = {};
  CHECK(around_circle_sections(nothing).empty());
  CHECK(run_contrast_sections(nothing).empty());
}

TEST_CASE("pairs, groups and reversals of runs") {
  const std::vector<Json> sections = run_contrast_sections(testing::small_diagnosis());
  REQUIRE(sections.size() == 3);
  const Json pair = testing::row_of(sections[0], "direction");
  CHECK(pair[1] == 2);
  CHECK(pair[2].get<double>() == Approx(1));
  CHECK(pair[3].get<double>() == Approx(1));
  CHECK(pair[4].get<double>() == Approx(4));  // 2 um of 0.5
  CHECK(pair[5].get<double>() == Approx(2));
  CHECK(testing::row_of(sections[1], "tilt 0 to 5 deg")[2].get<double>() == Approx(6.2));
  const Json step = testing::row_of(sections[2], "strut 1")["bars"][0];
  CHECK(step["value"].get<double>() == Approx(4));
  CHECK(step["low"].get<double>() == Approx(3));
  CHECK(step["high"].get<double>() == Approx(5));
  CHECK(step["style"] == 2);  // eight standard errors
}

TEST_CASE("residuals go around the circle in the order of their angles") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.runs[0].angle = Eigen::Vector4d(0, -1, -2, -3);  // clockwise
  d.runs[0].radial_before = Eigen::Vector4d(1, 2, 3, 4) * 1e-6;
  measure::Run run;
  run.id = "first";
  run.radius = 0.144;
  const Json json = residual_circles_section(d, {run});
  REQUIRE(json["groups"].size() == 2);
  const Json& group = json["groups"][0];
  CHECK(group["radius_mm"].get<double>() == Approx(144));
  CHECK(group["curves"][0]["values"] == packed(std::vector<double>{1, 4, 3, 2}, 1e-3));
  CHECK(group["facts"][0]["value"].get<double>() == Approx(3.1));
  for (diagnose::RunGap& of : d.runs) of.radial_before = of.radial_after = of.angle = Eigen::VectorXd();
  CHECK(residual_circles_section(d, {run}).is_null());
}

TEST_CASE("circles are told as measured and as compensation would leave them") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  const Json bars = testing::row_of(circularity_section(d), "first")["bars"];
  CHECK(bars[0]["value"].get<double>() == Approx(20));
  CHECK(bars[1]["value"].get<double>() == Approx(9));
  CHECK(bars[2]["value"].get<double>() == Approx(4));
  d.runs[0].circularity.reset();
  CHECK(circularity_section(d).is_null());
}

}  // namespace
}  // namespace plumbline::report
