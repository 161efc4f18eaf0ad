#include "report/page/run_sections.hpp"

#include <catch2/catch.hpp>

#include "support/page_sections.hpp"
#include "support/run_profiles.hpp"

namespace plumbline::report {
namespace {

Json values_um(std::initializer_list<double> values) { return packed(std::vector<double>(values), 1e-3); }

TEST_CASE("circles show what was measured, simulated and would be left") {
  const Json json = circles_section(testing::small_runs(), "Circles");
  REQUIRE(json["groups"].size() == 1);  // the other run has no bar
  const Json& group = json["groups"][0];
  CHECK(group["name"] == "a");
  CHECK(group["radius_mm"].get<double>() == Approx(144));
  REQUIRE(group["curves"].size() == 5);
  CHECK(group["curves"][0]["name"] == "measured");
  CHECK(group["curves"][0]["angle"] == packed(std::vector<double>{0, 90, 180, 270}, 1e-3));
  CHECK(group["curves"][0]["values"] == values_um({1, -1, 1, -1}));
  CHECK(group["curves"][1]["name"] == "simulated (first)");
  CHECK(group["curves"][1]["values"] == values_um({0, -2, 0, -2}));
  CHECK(group["curves"][4]["name"] == "compensated (second)");
  CHECK(group["curves"][4]["values"] == values_um({0.5, 0, -0.5, 0}));
  CHECK(group["facts"][0]["value"].get<double>() == Approx(2));
  CHECK(group["facts"][1]["name"] == "Circular deviation G");
}

TEST_CASE("one model needs no name in a legend, none leaves the measured circle") {
  jobs::RunsAndModels runs = testing::small_runs();
  runs.models.pop_back();
  for (jobs::RunProfile& run : runs.runs) run.models.pop_back();
  CHECK(circles_section(runs, "t")["groups"][0]["curves"][1]["name"] == "simulated");
  runs.models.clear();
  for (jobs::RunProfile& run : runs.runs) run.models.clear();
  CHECK(circles_section(runs, "t")["groups"][0]["curves"].size() == 1);
  CHECK(left_along_turn_section(runs, "t").is_null());
  CHECK(torque_map_section(runs, "t").is_null());
  CHECK(left_by_run_sections(runs).empty());
}

TEST_CASE("what is left is told by run, a bar for each model") {
  const std::vector<Json> sections = left_by_run_sections(testing::small_runs());
  REQUIRE(sections.size() == 2);
  CHECK(sections[0]["unit"] == "um");
  const Json bars = testing::row_of(sections[0], "a")["bars"];
  CHECK(bars[0]["value"].get<double>() == Approx(1));
  CHECK(bars[1]["value"].get<double>() == Approx(2));
  CHECK(testing::row_of(sections[0], "<b>")["bars"][0]["why"] == "not measured");
  CHECK(sections[1]["unit"] == "N m");
  CHECK(testing::row_of(sections[1], "<b>")["bars"][1]["value"].get<double>() == Approx(0.2));
}

TEST_CASE("along the turn each channel has a panel") {
  const Json turn = turn_section(testing::small_runs(), "Along");
  CHECK(turn["groups"][0]["panels"].size() == 7);
  CHECK(turn["groups"][1]["panels"].size() == 6);
  CHECK(turn["groups"][1]["panels"][0]["name"] == "Motor 1");
  const Json left = left_along_turn_section(testing::small_runs(), "Left");
  CHECK(left["groups"][0]["panels"][0]["series"][1]["values"] == values_um({2, 2, 2, 2}));
  CHECK(left["groups"][1]["panels"][5]["series"][0]["values"] == packed(std::vector<double>(4, 0.1), 1e-5));
  const Json map = torque_map_section(testing::small_runs(), "Map");
  CHECK(map["rows"]["labels"] == Json{"a", "<b>"});
  CHECK(map["figures"][1]["planes"][0]["values"] == packed(std::vector<double>(12, 0.2), 1e-5));
}

TEST_CASE("what is not there is no section") {
  Page page;
  add_section(page, nullptr);
  CHECK(page.sections.empty());
  add_section(page, Json{{"type", "text"}});
  CHECK(page.sections.size() == 1);
}

}  // namespace
}  // namespace plumbline::report
