#include "report/page/plan_page.hpp"

#include <limits>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/page_sections.hpp"
#include "support/run_profiles.hpp"
#include "support/scratch.hpp"

namespace plumbline::report {
namespace {

using testing::section_of;

machine::MachineModel pm600() { return machine::read_model(testing::source_file("models/pm600-like.toml")); }

// Backlash of strut 1, which nothing tells before, and a coordinate of a joint.
jobs::PlannedTests two_circles() {
  identify::Unknowns unknowns{physics::ForceModel(pm600())};
  unknowns.add("backlash", "width_um", 0);
  unknowns.add("joint-position", "base_um", 0);
  jobs::PlannedTests plan(std::move(unknowns));
  plan.before.covariance = Eigen::Vector2d(1, 1600e-12).asDiagonal();
  plan.before.covariance(0, 0) = std::numeric_limits<double>::infinity();
  plan.after.covariance = Eigen::Vector2d(0.04e-12, 100e-12).asDiagonal();
  plan.asked = {0, 1};
  plan.candidates = 500;
  for (const char* const id : {"01-ccw", "02-cw"}) {
    measure::Run run;
    run.id = id;
    run.centre_W = {0.1, -0.05, -1};
    run.radius = 0.15;
    run.feed = 1000 * kMmPerMin;
    plan.dataset.runs.push_back(run);
  }
  plan.criterion = {12.25, 20};
  return plan;
}

TEST_CASE("a plan is drawn with its programs, and says what it tells") {
  const Page page = plan_page(two_circles(), pm600(), {"G2", "G3"}, {});
  CHECK(page.lead == "2 circles bring the standard errors of what is asked for down to 25 % (median of 2 numbers).");
  CHECK(section_of(page, "The circles")["rows"][1][10].get<double>() == 20);
  const Json tests = section_of(page, "The circles in the machine")["tests"];
  CHECK(tests[1]["name"] == "02-cw");
  CHECK(tests[1]["program"] == "G3");
  const Json told = section_of(page, "What the plan tells");
  REQUIRE(told["rows"].size() == 1);  // of the other nothing was known
  CHECK(told["rows"][0]["bars"][0]["value"].get<double>() == Approx(25));
  CHECK(section_of(page, "What each circle adds")["groups"][0]["panels"][0]["series"][0]["values"] ==
        packed(std::vector<double>{12.25, 20}, 1e-4));
  CHECK(section_of(page, "Standard errors")["rows"][0][1] == "not told");
  CHECK(section_of(page, "Standard errors")["rows"][0][2] == "0.2");
}

TEST_CASE("a plan for the tip shows how certain each circle makes it") {
  jobs::PlannedTests plan = two_circles();
  const auto over = [](double um) {
    return jobs::TipOverBox{{um * kUm, 2 * um * kUm, {}}, {um / 4 * kUm, um / 2 * kUm, {}}};
  };
  plan.tip = jobs::PlannedTip{
      {machine::Range{-0.1, 0.1}, {-0.06, 0.06}, {-1.1, -0.9}}, {0}, 125, 125, over(20), {over(16), over(12)}};
  const Page page = plan_page(plan, pm600(), {}, {});
  CHECK(page.lead ==
        "2 circles bring the tip's uncertainty over the box from 20 to 12 um as it stands, with the zero touched off "
        "from "
        "5 to 3 um (1 sigma, rms).");
  const Json rows = section_of(page, "The tip over the box")["rows"];
  REQUIRE(rows.size() == 2);
  CHECK(rows[1][2].get<double>() == Approx(3));
  CHECK(rows[1][4].get<double>() == Approx(6));
  const Json panel = section_of(page, "What each circle adds")["groups"][0]["panels"][0];
  CHECK(panel["series"][0]["values"] == packed(std::vector<double>{20, 16, 12}, 1e-4));
  CHECK(panel["series"][1]["values"] == packed(std::vector<double>{5, 4, 3}, 1e-4));
}

TEST_CASE("what the model predicts is not called measured") {
  jobs::RunsAndModels runs = testing::small_runs();
  runs.models.clear();
  for (jobs::RunProfile& run : runs.runs) run.models.clear();
  runs.readings = "predicted";
  const Page page = plan_page(two_circles(), pm600(), {}, runs);
  CHECK(section_of(page, "What the model predicts")["groups"][0]["curves"][0]["name"] == "predicted");
  CHECK_FALSE(testing::says(section_of(page, "What the model predicts"), "measured"));
  CHECK_FALSE(testing::says(section_of(page, "Predicted along the turn"), "measured"));
}

TEST_CASE("a plan that separates two effects says by how much") {
  jobs::PlannedTests plan = two_circles();
  plan.apart = {3.25, 4.5};
  CHECK(plan_page(plan, pm600(), {}, {}).lead ==
        "2 circles tell the two effects apart by 3.25 and 4.5 sigma, for a hundredth of their range.");
}

}  // namespace
}  // namespace plumbline::report
