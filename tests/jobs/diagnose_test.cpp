// Verdicts of whole searches are in tests/diagnose and tests/blind, their words in tests/report.
#include "jobs/diagnose.hpp"

#include <catch2/catch.hpp>

#include "jobs/dataset_files.hpp"
#include "jobs/simulate_dataset.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("a diagnosis of files has the model, and what is wrong with a channel") {
  const Scratch scratch;
  const std::string model = source_file("models/pm600-like.toml");
  jobs::simulate_dataset(model, scratch.file("plan/dataset.toml", plan_text(scratch)), scratch.path("sim"));
  // torques of motor 2 tenfold: no effect does that, and nothing is searched for
  for (const char* const table : {"sim/a.csv", "sim/b.csv"}) scratch.file(table, scaled(scratch.text(table), 10, 3));
  const jobs::DiagnoseResult result = jobs::diagnose({model, scratch.path("sim/dataset.toml"), {}, 1});
  CHECK(result.machine.name == "pm600-like");
  CHECK(result.thinning.runs == 2);
  CHECK(result.thinning.thinned == 0);
  REQUIRE(result.diagnosis.withheld);
  CHECK(std::get<diagnose::ChannelFlaw>(*result.diagnosis.withheld).motors == std::vector<std::size_t>{1});
}

TEST_CASE("effects that are left out must be in the catalogue") {
  const Scratch scratch;
  const std::string dataset = scratch.file("plan/dataset.toml", plan_text(scratch));
  const Diagnostic d = refusal_of([&] {
    jobs::diagnose({source_file("models/pm600-like.toml"), dataset, {"backlsh"}, 1});
  });
  CHECK(d.code == "diagnose-unknown-effect");
}

TEST_CASE("a diagnosis says how far what it found moves the tip") {
  const jobs::DiagnoseResult result = jobs::diagnose(
      {source_file("tests/blind/open-01/base.toml"), source_file("tests/blind/open-01/data/dataset.toml"), {}, 1});
  CHECK(result.runs.size() == 26);
  REQUIRE(result.at_tip.size() == 1);
  CHECK(result.at_tip[0].effect == "backlash");
  // struts that are off by up to 1 um either way (half of 2.0 um), through the machine's own leverage
  CHECK(result.at_tip[0].largest > 1e-6);
  CHECK(result.at_tip[0].largest < 10e-6);
  CHECK(result.at_tip[0].rms < result.at_tip[0].largest);
  CHECK(result.at_tip[0].rms > 0.2e-6);
}
