#include "report/page/measured_sections.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace plumbline::report {
namespace {

TEST_CASE("curves come in groups of panels over one axis") {
  CurvePanel panel{"Motor 1", "N m", {{"measured", 6, 1, {0.5, -0.25}}}, 3, 0.25, {{"largest", 1}}};
  const Json json = curves_section("Torques", {.name = "Angle", .unit = "deg", .range = {{0, 360}}},
                                   {{"run a", {0, 180}, {panel}, "F1000"}}, {.choose = "Run", .words = "w"});
  CHECK(json["type"] == "curves");
  CHECK(json["title"] == "Torques");
  CHECK(json["words"] == "w");
  CHECK(json["axis"] == Json{{"name", "Angle"}, {"unit", "deg"}, {"digits", 1}, {"range", {0.0, 360.0}}});
  const Json& group = json["groups"][0];
  CHECK(group["name"] == "run a");
  CHECK(group["note"] == "F1000");
  CHECK(group["x"] == packed(std::vector<double>{0, 180}, 1e-3));
  const Json& series = group["panels"][0]["series"][0];
  CHECK(series["style"] == 6);
  CHECK(series["dash"] == 1);
  CHECK(series["values"] == packed(std::vector<double>{0.5, -0.25}, 0.25));
  CHECK(group["panels"][0]["limits"][0] == Json{{"name", "largest"}, {"value", 1.0}});
}

TEST_CASE("a line has the pattern of its style unless it says another one") {
  const Json json = polar_section("t", {{"a", 144, {{"measured", 2, 0, {0}, {1.5}}}, {{"G", 3.25}}}});
  const Json& group = json["groups"][0];
  CHECK(group["radius_mm"] == 144);
  CHECK_FALSE(group["curves"][0].contains("dash"));
  CHECK(group["curves"][0]["values"] == packed(std::vector<double>{1.5}, 1e-3));
  CHECK(group["facts"][0] == Json{{"name", "G"}, {"value", 3.25}, {"unit", "um"}, {"digits", 2}});
  CHECK_FALSE(json.contains("words"));
}

TEST_CASE("a map of colours says why cells have no value") {
  HeatMap map;
  map.rows = {"Y", "mm", {}, {-100, 100}};
  map.columns = {"Motor", "", {"1", "2"}};
  map.reasons = {"out of reach"};
  map.figures = {{"error", "um", 1, {{"A 0", {1, std::nan(""), 3, 4}, {-1, 0, -1, -1}}}, {{1, 10}}, true}};
  const Json json = heat_section("Map", map);
  CHECK(json["rows"] == Json{{"name", "Y"}, {"unit", "mm"}, {"values", {-100.0, 100.0}}});
  CHECK(json["columns"]["labels"] == Json{"1", "2"});
  const Json& figure = json["figures"][0];
  CHECK(figure["log"] == true);
  CHECK(figure["range"] == Json{1.0, 10.0});
  CHECK(figure["planes"][0]["reasons"] == Json{{"1", 0}});
  CHECK(figure["planes"][0]["values"] == packed(std::vector<double>{1, std::nan(""), 3, 4}, 1e-3));
}

TEST_CASE("a bar has a value and an interval, or a reason") {
  BarChart chart{"um", 2, {{"before", 2}}};
  chart.rows = {{"a", {{1.5, 1, 2, 2}}}, {"b", {{{}, {}, {}, 1, "not measured"}}}};
  chart.references = {{"limit", 3}};
  const Json json = bars_section("Bars", chart);
  CHECK(json["series"][0] == Json{{"name", "before"}, {"style", 2}});
  CHECK(json["rows"][0]["bars"][0] == Json{{"value", 1.5}, {"style", 2}, {"low", 1.0}, {"high", 2.0}});
  CHECK(json["rows"][1]["bars"][0] == Json{{"value", nullptr}, {"style", 1}, {"why", "not measured"}});
  CHECK(json["references"][0]["value"] == 3);
  chart.rows = {{"c", {{std::nan("")}}}};
  CHECK(bars_section("Bars", chart)["rows"][0]["bars"][0]["value"].is_null());
}

}  // namespace
}  // namespace plumbline::report
