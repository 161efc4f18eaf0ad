#include "jobs/simulate_dataset.hpp"

#include <catch2/catch.hpp>

#include "jobs/dataset_files.hpp"
#include "measure/circularity.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("a dataset is simulated with its own columns, and has the circularity of an independent program") {
  const Scratch scratch;
  const std::string plan = scratch.file("plan/dataset.toml", plan_text(scratch));
  jobs::simulate_dataset(source_file("models/pm600-like.toml"), plan, scratch.path("sim"));
  CHECK(scratch.text("sim/dataset.toml") == scratch.text("plan/dataset.toml"));
  CHECK(scratch.text("sim/b.csv").starts_with("angle_deg,radial_um,torque1_Nm"));
  CHECK(scratch.text("sim/b.csv").find("\n357.000,") != std::string::npos);
  const measure::Dataset simulated = measure::read_dataset(scratch.path("sim/dataset.toml"));
  const auto figures = measure::circularity_figures(measure::profile_of(simulated.runs[0]));
  CHECK(figures.least_squares * 1e6 == Approx(208).margin(2).epsilon(0));
}

TEST_CASE("a dataset is not simulated over itself") {
  const Scratch scratch;
  const std::string plan = scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string before = scratch.text("plan/a.csv");
  const Diagnostic d =
      refusal_of([&] { jobs::simulate_dataset(source_file("models/pm600-like.toml"), plan, scratch.path("plan")); });
  CHECK(d.code == "file-overwrites-input");
  CHECK(scratch.text("plan/a.csv") == before);
}
