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
