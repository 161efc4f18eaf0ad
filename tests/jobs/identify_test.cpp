#include "jobs/identify.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/text/hash.hpp"
#include "jobs/dataset_files.hpp"
#include "jobs/simulate_dataset.hpp"
#include "report/measured/identification_text.hpp"
#include "report/measured/model_file.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("identification of exact data changes next to nothing, and records where it comes from") {
  const Scratch scratch;
  const std::string plan = scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string model = source_file("models/pm600-like.toml");
  jobs::simulate_dataset(model, plan, scratch.path("sim"));
  const std::string dataset = scratch.path("sim/dataset.toml");
  const jobs::IdentifiedModel same = jobs::identify_model(model, dataset, {});
  CHECK(same.found.converged());
  CHECK(same.found.after.radial_rms < 1e-9);
  CHECK(same.thinning.runs == 2);
  const std::string text = report::model_file(same);
  CHECK(text.find("; refitted by plumbline 0.") != std::string::npos);
  CHECK(text.find("sim/dataset.toml (fnv1a " + to_hex(same.measured[0].hash) + ", 2 runs), model fnv1a ") !=
        std::string::npos);
  CHECK(text.find("#   K1: 0.01287 -> 0.012") != std::string::npos);

  // another table, another fingerprint
  scratch.file("sim/a.csv", shifted(scratch.text("sim/a.csv"), 1));
  CHECK(jobs::identify_model(model, dataset, {}).measured[0].hash != same.measured[0].hash);
}

TEST_CASE("the JSON of an identification holds every unknown with its error and correlations") {
  const Scratch scratch;
  const std::string plan = scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string model = source_file("models/pm600-like.toml");
  jobs::simulate_dataset(model, plan, scratch.path("sim"));
  const jobs::IdentifiedModel found =
      jobs::identify_model(model, scratch.path("sim/dataset.toml"), {.stages = identify::Stages::paper});
  const auto json = nlohmann::json::parse(report::identification_json(found.found));
  REQUIRE(json["stages"].size() == 2);
  const auto& torques = json["stages"][0];
  CHECK(torques["unknowns"].size() == 9);
  CHECK(torques["unknowns"][0]["label"] == "motor mass");
  CHECK(torques["unknowns"][0]["prior_sigma"].is_null());
  CHECK(torques["unknowns"][3]["index"] == 1);
  CHECK(torques["correlations"].size() == 9);
  CHECK(torques["correlations"][4][4].get<double>() == Approx(1));
  CHECK(torques["noise"]["torque6"]["sigma_Nm"].get<double>() > 0);
  CHECK(json["stages"][1]["unknowns"][1]["value"].get<double>() == Approx(0.00782).epsilon(0.01));
  CHECK(json["gap"]["after"]["torque_rms_Nm"].get<double>() < 1e-4);
  CHECK(report::identification_text(found.found).find("bar readings fit") != std::string::npos);
}
