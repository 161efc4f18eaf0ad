#include "report/page/identification_page.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/page_sections.hpp"
#include "support/run_profiles.hpp"
#include "support/scratch.hpp"

namespace plumbline::report {
namespace {

using testing::row_of;
using testing::section_of;

// Backlash of strut 1, free, and one coordinate of a joint, known to 50 um.
jobs::IdentifiedModel small_model() {
  machine::MachineModel machine = machine::read_model(testing::source_file("models/pm600-like.toml"));
  const physics::ForceModel forces(machine);
  identify::Identification found{{}, forces, {}, {}};
  identify::Unknowns unknowns(forces);
  unknowns.add("backlash", "width_um", 0);
  unknowns.set_prior(unknowns.add("joint-position", "base_um", 0), 50 * kUm);
  identify::Fit fit(std::move(unknowns));
  fit.values = Eigen::Vector2d(4.1, -12.5) * kUm;
  fit.covariance = Eigen::Vector2d(0.1 * kUm, 40 * kUm).cwiseAbs2().asDiagonal();
  fit.readings = 240;
  fit.converged = true;
  found.stages.push_back({"joint", std::move(fit), {}, {}, {}, true, {}});
  found.before.radial_rms = 3.1e-6;
  found.after.radial_rms = 0.6e-6;
  found.before.radial_readings = found.after.radial_readings = 120;
  return {std::move(machine), std::move(found), {}, {}, {}, forces, {}, {}, {}, {}, {}, false, {}};
}

TEST_CASE("an identification says what is left, what was found and how far it moved") {
  const Page page = identification_page(small_model(), testing::small_runs());
  CHECK(page.title == "Identification of pm600-like");
  CHECK(page.lead == "The model as found is off by 0.60 um in readings of the bar (3.10 um before) (rms).");
  CHECK(page.verdict == Verdict::good);
  CHECK(page.sections[0]["title"] == "At a glance");
  const Json values = section_of(page, "What was found: joint fit");
  REQUIRE(values["rows"].size() == 2);
  CHECK(values["rows"][0][2] == "4.1");
  CHECK(values["rows"][0][4] == "free");
  CHECK(values["rows"][1][3] == "40");
  CHECK(values["rows"][1][4] == "50");
  const Json bars = section_of(page, "How far the numbers moved: joint fit");
  REQUIRE(bars["rows"].size() == 1);  // what has a prior
  const Json bar = bars["rows"][0]["bars"][0];
  CHECK(bar["value"].get<double>() == Approx(-0.25));
  CHECK(bar["low"].get<double>() == Approx(-0.25 - 1.6));
  CHECK(bar["high"].get<double>() == Approx(-0.25 + 1.6));
  const Json map = section_of(page, "Which numbers the data do not tell apart: joint fit");
  CHECK(map["figures"][0]["planes"][0]["values"] == packed(std::vector<double>{1, 0, 0, 1}, 1e-3));
  CHECK_FALSE(section_of(page, "Circles").is_null());
}

TEST_CASE("what a tracker saw is beside what the model says, axis by axis, before and after") {
  jobs::IdentifiedModel model = small_model();
  CHECK(section_of(identification_page(model, testing::small_runs()), "Poses of the tracker: what is left").is_null());
  jobs::TrackedGap gap;
  gap.before.shift = Vector3<double>(3, -4, 0) * kUm;
  gap.after.shift = Vector3<double>(0, 1, 0) * kUm;
  model.poses.assign(2, gap);
  const char* const title = "Poses of the tracker: what is left";
  const Json positions = section_of(identification_page(model, testing::small_runs()), title);
  const Json& panels = positions["groups"][0]["panels"];
  CHECK(positions["groups"][0]["x"] == packed(std::vector<double>{1, 2}, 1e-3));
  CHECK(panels[0]["series"][1]["points"] == true);
  REQUIRE(panels.size() == 4);
  CHECK(panels[0]["name"] == "Distance");
  CHECK(panels[0]["series"][0]["values"] == packed(std::vector<double>{5, 5}, 1e-3));
  CHECK(panels[2]["name"] == "Along Y");
  CHECK(panels[2]["unit"] == "um");
  CHECK(panels[2]["series"][0]["values"] == packed(std::vector<double>{-4, -4}, 1e-3));
  CHECK(panels[2]["series"][1]["values"] == packed(std::vector<double>{1, 1}, 1e-3));
  for (jobs::TrackedGap& of : model.poses) {
    of.before.turn = Vector3<double>(0, 0, 2e-5);
    of.after.turn = Vector3<double>(0, 0, -1e-6);
  }
  const Json turned = section_of(identification_page(model, testing::small_runs()), title);
  REQUIRE(turned["groups"][0]["panels"].size() == 7);
  CHECK(turned["groups"][0]["panels"][6]["name"] == "Turn about Z");
  CHECK(turned["groups"][0]["panels"][6]["series"][0]["values"] == packed(std::vector<double>{20, 20}, 1e-3));
}

TEST_CASE("what speaks against an identification comes first") {
  jobs::IdentifiedModel model = small_model();
  model.calibrated = true;
  model.open_gap = diagnose::OpenGap{{diagnose::ReadingKind::radial, 3e-6, 2e-6}};
  const Page page = identification_page(model, {});
  CHECK(page.title == "Calibration of pm600-like");
  CHECK(page.verdict == Verdict::warn);
  CHECK(page.sections[0]["type"] == "warnings");
  model.found.stages[0].fit.converged = false;
  const Page failed = identification_page(model, {});
  CHECK(failed.verdict == Verdict::bad);
  CHECK(failed.sections[0]["items"].size() == 2);
}

TEST_CASE("runs of an identification lie beside both models") {
  jobs::IdentifiedModel model = small_model();
  CHECK(profiles_of(model).runs.empty());
  CHECK(profiles_of(model).models == std::vector<std::string>{"as given", "as found"});
}

}  // namespace
}  // namespace plumbline::report
