#include "report/measured/plan_text.hpp"

#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

// Backlash of strut 1, which nothing tells before, and three coordinates of joints.
jobs::PlannedTests one_circle() {
  identify::Unknowns unknowns(physics::ForceModel(machine::read_model(testing::source_file("models/pm600-like.toml"))));
  unknowns.add("backlash", "width_um", 0);
  for (const int coordinate : {0, 1, 2}) unknowns.add("joint-position", "base_um", coordinate);
  jobs::PlannedTests plan(std::move(unknowns));
  const auto variances = [](double first, double x, double y, double z) {
    const Eigen::Vector4d errors_um{first, x, y, z};
    return Eigen::MatrixXd((errors_um * kUm).cwiseAbs2().asDiagonal());
  };
  plan.before.covariance = variances(1, 70, 50, 60);
  plan.before.covariance(0, 0) = std::numeric_limits<double>::infinity();
  plan.after.covariance = variances(0.2, 9, 1, 2);
  plan.asked = {0, 1, 2, 3};
  plan.candidates = 500;
  measure::Run run;
  run.id = "c01";
  run.centre_W = {0.1, -0.05, -1};
  run.radius = 0.15;
  run.tilt = {10 * kDeg, -5 * kDeg, 0};
  run.feed = 1000 * kMmPerMin;
  plan.dataset.runs = {run};
  plan.criterion = {12.25};
  return plan;
}

}  // namespace

TEST_CASE("a plan lists its runs, and what is known before and after") {
  const jobs::PlannedTests plan = one_circle();
  const std::string label = plan.after.unknowns[0].label;
  CHECK(report::plan_text(plan) ==
        "1 run of 500 candidates\n"
        "run                    centre, mm   radius         A, B, deg         mm/min   payload   criterion\n"
        "c01               100, -50, -1000      150            10, -5   ccw     1000         -       12.25\n"
        "\n"
        "standard error                          before       after   unit\n" +
            label + std::string(34 - label.size(), ' ') +
            "           -         0.2   um\n"
            "joint-position base_um                      60           2   um, median of 3; largest 9\n");
}

TEST_CASE("a payload, a distance and what stays unseen are told where there are any") {
  jobs::PlannedTests plan = one_circle();
  plan.dataset.runs[0].payload_mass = 20;
  plan.apart = {3.5, 12};
  plan.unseen.nothing = {0};
  plan.geometry = identify::ShownGeometry{36, 20, {}};
  const std::string text = report::plan_text(plan);
  CHECK(text.find("    1000     20 kg       12.25\n") != std::string::npos);
  CHECK(text.find("from the other effect: 3.5 and 12 sigma for a hundredth of its range\n") != std::string::npos);
  CHECK(text.ends_with(
      "note: these data say nothing about " + plan.after.unknowns[0].label +
      "\nnote: these data determine 20 of 36 directions of the geometry to better than half of what was known\n"));
}

TEST_CASE("a plan as JSON has its runs to be measured, and null for what nothing tells") {
  jobs::PlannedTests plan = one_circle();
  nlohmann::json json = nlohmann::json::parse(report::plan_json(plan));
  CHECK(json["plumbline"] == "plan 1");
  CHECK(json["candidates"] == 500);
  CHECK_FALSE(json.contains("apart_sigma"));
  CHECK(json["cannot_tell"] == nlohmann::json::array());
  const nlohmann::json& run = json["runs"][0];
  CHECK(run["id"] == "c01");
  CHECK(run["centre_mm"][1].get<double>() == Approx(-50));
  CHECK(run["bar_mm"].is_null());
  CHECK(run["tilt_deg"][0].get<double>() == Approx(10));
  CHECK(run["feed_mm_min"].get<double>() == Approx(1000));
  CHECK(run["criterion"] == 12.25);
  REQUIRE(json["unknowns"].size() == 4);
  CHECK(json["unknowns"][0]["before"].is_null());
  CHECK(json["unknowns"][0]["after"].get<double>() == Approx(0.2));
  CHECK(json["unknowns"][3]["index"] == 2);
  CHECK(json["unknowns"][3]["unit"] == "um");
  plan.apart = {3.5, 12};
  plan.dataset.runs[0].bar = 0.3;
  json = nlohmann::json::parse(report::plan_json(plan));
  CHECK(json["apart_sigma"] == nlohmann::json{3.5, 12.0});
  CHECK(json["runs"][0]["bar_mm"].get<double>() == Approx(300));
}

TEST_CASE("a plan for the tip says how certain it becomes over the box") {
  jobs::PlannedTests plan = one_circle();
  CHECK_FALSE(nlohmann::json::parse(report::plan_json(plan)).contains("tip"));
  AxisWords worst;
  worst[Axis::Y] = -60;
  worst[Axis::B] = 10;
  const auto over = [&](double um) {
    return jobs::TipOverBox{{um * kUm, 2 * um * kUm, worst}, {um / 4 * kUm, um / 2 * kUm, worst}};
  };
  plan.tip = jobs::PlannedTip{
      {machine::Range{-0.1, 0.1}, {-0.06, 0.06}, {-1.1, -0.9}}, {0, 10 * kDeg}, 625, 600, over(20), {over(12)}};
  CHECK(report::plan_text(plan).find("the tip over X -100 to 100, Y -60 to 60, Z -1100 to -900 mm, tilted by 0, 10 deg "
                                     "(600 of 625 poses in reach), 1 "
                                     "sigma\n"
                                     "as it stands, rms                           20          12   um\n"
                                     "as it stands, worst                         40          24   um\n"
                                     "zero touched off, rms                        5           3   um\n"
                                     "zero touched off, worst                     10           6   um\n") !=
        std::string::npos);
  const nlohmann::json tip = nlohmann::json::parse(report::plan_json(plan)).at("tip");
  CHECK(tip.at("box_mm")[2][0].get<double>() == Approx(-1100));
  CHECK(tip.at("tilts_deg")[1].get<double>() == Approx(10));
  CHECK(tip.at("reached") == 600);
  CHECK(tip.at("before").at("touched_off").at("rms_um").get<double>() == Approx(5));
  REQUIRE(tip.at("after").size() == 1);
  CHECK(tip.at("after")[0].at("stands").at("worst_um").get<double>() == Approx(24));
  CHECK(tip.at("after")[0].at("stands").at("worst_at").at("b_deg") == 10);
  CHECK(tip.at("after")[0].at("stands").at("worst_at").at("y_mm") == -60);
}
