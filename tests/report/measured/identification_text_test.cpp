#include "report/measured/identification_text.hpp"

#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using Json = nlohmann::json;

namespace {

// Backlash of strut 1, free, and one coordinate of a joint, known to 50 um and not told by the data.
identify::Identification small_identification(const char* stage_name = "joint") {
  identify::Identification found{
      {}, physics::ForceModel(machine::read_model(testing::source_file("models/pm600-like.toml"))), {}, {}};
  identify::Unknowns unknowns(found.forces);
  unknowns.add("backlash", "width_um", 0);
  unknowns.set_prior(unknowns.add("joint-position", "base_um", 0), 50 * kUm);
  identify::Fit fit(std::move(unknowns));
  fit.values = Eigen::Vector2d(4.1, -12.5) * kUm;
  fit.covariance = Eigen::Vector2d(0.1 * kUm, 40 * kUm).cwiseAbs2().asDiagonal();
  fit.readings = 240;
  fit.converged = true;
  fit.noise.channels[identify::kRadial] = {0.5e-6, 0.25, 120, 0};
  fit.noise.channels[1] = {0.05, 0.25, 120, 1};
  found.stages.push_back({stage_name, std::move(fit), {}, {}, {}, false, {}});
  found.before.radial_rms = 3.1e-6;
  found.after.radial_rms = 0.6e-6;
  found.before.radial_readings = found.after.radial_readings = 120;
  return found;
}

bool says(const identify::Identification& found, const std::string& line) {
  std::string text = "\n";
  text += report::identification_text(found);
  return text.find("\n" + line) != std::string::npos;
}

}  // namespace

TEST_CASE("an identification is told with its values, its noise and the gap") {
  const identify::Identification found = small_identification();
  const std::string label = found.stages[0].fit.unknowns[0].label;
  CHECK(report::identification_text(found) ==
        "joint fit: 240 readings, 2 unknowns, converged\n"
        "                                      before       found          +-    known to   unit\n" +
            label + std::string(32 - label.size(), ' ') +
            "           0         4.1         0.1           -   um\n"
            "joint-position                  1 number, moved by up to 12.50 um\n"
            "noise of the bar: 0.500 um\n"
            "noise of the torques: 0.0500 N m\n"
            "\n"
            "bar readings: rms 3.100 -> 0.600 um\n");
}

TEST_CASE("a fit that did not converge, notes and other readings are told") {
  identify::Identification found = small_identification();
  identify::Stage& stage = found.stages[0];
  stage.fit.converged = false;
  stage.fit.stopped_because = "40 iterations";
  stage.observability.nothing = {0};
  stage.fit.noise.channels[identify::kTracker] = {12.5e-6, 0, 30, 1};
  stage.fit.noise.channels[identify::kTrackerTilt] = {20e-6, 0, 30, 1};
  found.before.torque_rms = 0.25;
  found.before.torque_mean_abs = 0.125;
  found.before.torque_readings = 720;
  found.before.tracker_rms = 100e-6;
  found.before.tracker_readings = 90;
  CHECK(says(found, "joint fit: 240 readings, 2 unknowns, NOT CONVERGED: 40 iterations\n"));
  CHECK(says(found, "note: these data say nothing about " + stage.fit.unknowns[0].label + "\n"));
  CHECK(says(found, "noise of the tracker: 12.50 um\n"));
  CHECK(says(found, "noise of the tracker's angles: 20.00 urad\n"));
  CHECK(says(found, "torques: rms 0.2500 -> 0.0000 N m, mean error 0.1250 -> 0.0000 N m\n"));
  CHECK(says(found, "tracker: rms 100.00 -> 0.00 um\n"));
  found.before.tilt_readings = 90;
  found.before.tilt_rms = 50e-6;
  CHECK(says(found, "tracker: rms 100.00 -> 0.00 um, 50.00 -> 0.00 urad\n"));
}

TEST_CASE("a calibration lists the joints, three coordinates a line") {
  const identify::Identification found = small_identification("calibration");
  CHECK(says(found, "true minus believed, um:         x                   y                   z\n"));
  CHECK(says(found, "base joint 1          -12.50 +- 40     "));
  CHECK(says(found, "calibration fit: "));
  CHECK_FALSE(says(small_identification(), "base joint 1"));
}

TEST_CASE("an identification as JSON has values, priors and correlations") {
  const Json found = Json::parse(report::identification_json(small_identification()));
  CHECK(found["plumbline"] == "identification 1");
  CHECK(found["converged"] == true);
  const Json& stage = found["stages"][0];
  CHECK(stage["name"] == "joint");
  CHECK(stage["readings"] == 240);
  const Json& width = stage["unknowns"][0];
  CHECK(width["effect"] == "backlash");
  CHECK(width["key"] == "width_um");
  CHECK(width["index"] == 0);
  CHECK(width["before"] == 0.0);
  CHECK(width["value"].get<double>() == Approx(4.1));
  CHECK(width["standard_error"].get<double>() == Approx(0.1));
  CHECK(width["prior_sigma"].is_null());
  CHECK(stage["unknowns"][1]["prior_sigma"].get<double>() == Approx(50));
  CHECK(stage["correlations"][0][0].get<double>() == Approx(1));
  CHECK(stage["correlations"][0][1] == 0.0);
  CHECK(stage["noise"]["radial"]["sigma_um"].get<double>() == Approx(0.5));
  CHECK(stage["noise"]["torque1"]["sigma_Nm"] == 0.05);
  CHECK_FALSE(stage["noise"].contains("torque2"));
  CHECK(found["gap"]["before"]["radial_rms_um"].get<double>() == Approx(3.1));
  CHECK(found["gap"]["after"]["torque_rms_Nm"].is_null());
}

TEST_CASE("what speaks against a stage, and what was held, is there or null") {
  identify::Identification found = small_identification();
  Json plain = Json::parse(report::identification_json(found))["stages"][0];
  CHECK(plain["objection"].is_null());
  CHECK(plain["held"].is_null());
  CHECK(plain["left_out"]["radial_rms_um"].is_null());
  identify::Stage& stage = found.stages[0];
  stage.objection = identify::Objection::strained;
  stage.plausible.strained = {{1, 7.5}};
  stage.plausible.radial = {3e-6, 1e-6, 0, 120};
  stage.fit.covariance(0, 0) = std::numeric_limits<double>::infinity();
  stage.held.emplace();
  stage.held->share = 0.5;
  stage.held->back = 3e-6;
  stage.held->whole = {10e-6, 2e-6, 4, 0.005};
  const Json all = Json::parse(report::identification_json(found))["stages"][0];
  CHECK(all["objection"] == stage.fit.unknowns[1].label + " is 375 um off, 7.5 times what [uncertainty] says of it");
  CHECK(all["strained"][0]["sigmas"] == 7.5);
  CHECK(all["strained"][0]["label"] == stage.fit.unknowns[1].label);
  CHECK(all["left_out"]["radial_rms_um"]["after"].get<double>() == Approx(1));
  CHECK(all["unknowns"][0]["standard_error"].is_null());
  CHECK(all["held"]["share"] == 0.5);
  CHECK(all["held"]["back_um"].get<double>() == Approx(3));
  CHECK(all["held"]["tip"]["moved_um"].get<double>() == Approx(10));
  CHECK(all["held"]["tip"]["chance_of_worse"] == 0.005);
}
