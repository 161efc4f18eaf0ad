#include "jobs/compare.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jobs/dataset_files.hpp"
#include "jobs/measured/inspect.hpp"
#include "jobs/measured/joined.hpp"
#include "jobs/simulate_dataset.hpp"
#include "report/measured/compare_text.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("a model agrees with what it simulated, whatever the set-up") {
  const Scratch scratch;
  const std::string plan = scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string model = source_file("models/pm600-like.toml");
  const jobs::DatasetSimulationSummary summary = jobs::simulate_dataset(model, plan, scratch.path("sim"));
  CHECK(summary.runs == 2);
  CHECK(summary.samples == 240);
  const jobs::Comparison same = jobs::compare(model, measure::read_dataset(scratch.path("sim/dataset.toml")));
  CHECK(*same.radial_rms_um < 1e-3);  // the digits of the table
  CHECK(*same.torque_rms_Nm < 1e-5);

  // readings that are 5 um more all around are a bar that was 5 um shorter
  scratch.file("sim/a.csv", shifted(scratch.text("sim/a.csv"), 5));
  const jobs::Comparison shifted_bar = jobs::compare(model, measure::read_dataset(scratch.path("sim/dataset.toml")));
  CHECK(*shifted_bar.radial_rms_um < 1e-3);
  CHECK(shifted_bar.runs[0].bar_um == Approx(-5).margin(1e-3));
  CHECK(shifted_bar.runs[1].bar_um == Approx(0).margin(1e-3));
}

TEST_CASE("a comparison pools all samples and struts, and says so in JSON") {
  const Scratch scratch;
  const std::string plan = scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string model = source_file("models/pm600-like.toml");
  jobs::simulate_dataset(model, plan, scratch.path("sim"));
  // 0.2 N m on motor 1 of run a, every sample: rms 0.2 sqrt(1/6) there, sqrt(1/12) over both runs
  scratch.file("sim/a.csv", shifted(scratch.text("sim/a.csv"), 0.2, 2));
  const jobs::Comparison found = jobs::compare(model, measure::read_dataset(scratch.path("sim/dataset.toml")));
  CHECK(*found.runs[0].torque_rms_Nm == Approx(0.2 / std::sqrt(6.0)).epsilon(1e-4));
  CHECK(*found.torque_rms_Nm == Approx(0.2 / std::sqrt(12.0)).epsilon(1e-4));
  CHECK(found.runs[0].torque_mean_abs_Nm[0] == Approx(0.2).epsilon(1e-4));
  CHECK(found.torque_mean_abs_Nm[0] == Approx(0.1).epsilon(1e-3));

  const auto json = nlohmann::json::parse(report::compare_json(found));
  CHECK(json["torque_rms_Nm"].get<double>() == *found.torque_rms_Nm);
  CHECK(json["runs"][1]["id"] == "b");
  CHECK(json["runs"][1]["radial_rms_um"].get<double>() < 1e-3);
  CHECK(report::compare_text(found).find("\nall ") != std::string::npos);
}

TEST_CASE("what was not measured is left out of a comparison") {
  const Scratch scratch;
  std::string table = "angle_deg,radial_um\n";
  for (int i = 0; i < 36; ++i) table += fmt::format("{},0\n", 10 * i);
  scratch.file("a.csv", table);
  const std::string dataset = scratch.file("dataset.toml", run_text("a", "ccw", "plumbline = \"dataset 1\"\n"));
  const jobs::Comparison found = jobs::compare(source_file("models/pm600-like.toml"), measure::read_dataset(dataset));
  CHECK(found.radial_rms_um.has_value());
  CHECK_FALSE(found.torque_rms_Nm.has_value());
  CHECK(nlohmann::json::parse(report::compare_json(found))["torque_rms_Nm"].is_null());
}

TEST_CASE("data that name another machine than the model are told") {
  const Scratch scratch;
  machine::MachineModel model;
  model.name = "pm600-like";
  measure::Dataset dataset;
  CHECK_FALSE(jobs::other_model(dataset, model));
  dataset.machine = "pm600-like";
  CHECK_FALSE(jobs::other_model(dataset, model));
  std::string table = "angle_deg,radial_um\n";
  for (int i = 0; i < 36; ++i) table += fmt::format("{},0\n", 10 * i);
  scratch.file("a.csv", table);
  const std::string path =
      scratch.file("dataset.toml", run_text("a", "ccw", "plumbline = \"dataset 1\"\nmachine = \"other\"\n"));
  const std::string file = source_file("models/pm600-like.toml");
  const std::optional<Diagnostic> told = jobs::compare(file, measure::read_dataset(path)).other_model;
  REQUIRE(told);
  CHECK(told->code == "dataset-other-model");
  CHECK(told->severity == Severity::warning);
  CHECK(told->place.line == 2);
  CHECK(jobs::inspect({file, path}).other_model);
  CHECK_FALSE(jobs::inspect({"", path}).other_model);
}
