#include "report/page/compare_page.hpp"

#include <catch2/catch.hpp>

#include "support/page_sections.hpp"
#include "support/run_profiles.hpp"

namespace plumbline::report {
namespace {

jobs::Comparison comparison(double radial_um) {
  jobs::Comparison of;
  of.radial_rms_um = radial_um;
  of.torque_rms_Nm = 0.05;
  of.runs = {{"a", radial_um, 0.05, {}, {1, 2, 3}, -4}, {"<b>", {}, 0.05, {}, {}, 0}};
  return of;
}

TEST_CASE("two models stand beside each other") {
  const Page page = compare_page({comparison(2.5), comparison(0.5)}, testing::small_runs());
  CHECK(page.title == "Model and measurements: first beside second");
  CHECK(page.lead ==
        "first is off by 2.50 um in readings of the bar and 0.050 N m in torques (rms); second is off by 0.50 um in "
        "readings of the bar and 0.050 N m in torques (rms).");
  const Json glance = testing::section_of(page, "At a glance");
  CHECK(testing::row_of(glance, "Bar, rms, second")["value"] == 0.5);
  for (const char* const title : {"Circles", "Bar: what is left, by run", "Motor torques: where they are off",
                                  "Along the turn", "What is left along the turn"}) {
    INFO(title);
    CHECK_FALSE(testing::section_of(page, title).is_null());
  }
  CHECK(testing::section_of(page, "Set-up of the runs, first")["rows"] ==
        Json::parse(R"([["a", 1.0, 2.0, 3.0, -4.0]])"));
}

TEST_CASE("what was not measured is said") {
  jobs::Comparison nothing = comparison(1);
  nothing.radial_rms_um.reset();
  nothing.runs[0].radial_rms_um.reset();
  const Page page = compare_page({nothing, comparison(1)}, testing::small_runs());
  CHECK(testing::row_of(testing::section_of(page, "At a glance"), "Bar, rms, first")["value"] == "not measured");
  CHECK(testing::section_of(page, "Set-up of the runs, first").is_null());
}

TEST_CASE("a page of circles has the figures of ISO 230-4, both directions and waves") {
  jobs::CircularityTable table;
  const measure::CircularityFigures figures{2e-6, 1.9e-6, 1.1e-6, -0.9e-6, {}};
  table.runs = {{"a", figures, {{1, 5e-6, 0}, {2, 1e-6, 0}, {3, 0.25e-6, 0}}},
                {"<b>", figures, {{1, 5e-6, 0}, {2, 3e-6, 0}}}};
  table.runs[1].figures.least_squares = 7e-6;
  table.pairs = {{"a", "<b>", {4e-6, 3e-6, -1e-6}}};
  jobs::RunsAndModels runs = testing::small_runs();
  runs.runs[1].run.radial = {4e-6, 2e-6, 4e-6, 2e-6};  // 3 um wider than the other one, each about its own circle alike
  runs.runs[1].radial = runs.runs[0].radial;
  runs.runs[1].figures = measure::CircularityFigures{2e-6, 2e-6, 4e-6, 2e-6, {3e-6, 0, 0}};
  const Page page = circularity_page(table, runs);
  CHECK(page.lead == "2 circles are between 2.0 um (a) and 7.0 um (<b>) out of round.");
  CHECK(testing::section_of(page, "Figures of ISO 230-4")["rows"][1][1].get<double>() == Approx(7));
  const Json pair = testing::section_of(page, "Both directions")["rows"][0];
  CHECK(pair[2].get<double>() == Approx(4));
  CHECK(pair[3].get<double>() == Approx(-1));
  const Json over = testing::section_of(page, "Both directions laid over each other")["groups"][0];
  CHECK(over["name"] == "a, <b>");
  CHECK(over["curves"][0]["values"] == packed(std::vector<double>{-0.5, -2.5, -0.5, -2.5}, 1e-3));
  CHECK(over["curves"][1]["values"] == packed(std::vector<double>{2.5, 0.5, 2.5, 0.5}, 1e-3));
  const Json waves = testing::section_of(page, "Waves around the circle");
  CHECK(waves["columns"]["labels"] == Json{"2", "3"});
  CHECK(waves["figures"][0]["planes"][0]["reasons"] == Json{{"3", 0}});
}

TEST_CASE("a page without circles says so") { CHECK(circularity_page({}, {}).lead == "No run has readings of a bar."); }

}  // namespace
}  // namespace plumbline::report
