#include "measure/dataset_text.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("a dataset that was made reads back as it was, in the units of the file") {
  const testing::Scratch scratch;
  measure::Run run;
  run.id = "01-cw";
  run.file = "01-cw.csv";
  run.centre_W = Vector3<double>(100, -50, -1008) * kMm;
  run.radius = 144 * kMm;
  run.bar = 150 * kMm;
  run.tilt = Vector3<double>(10, -5, 0) * kDeg;
  run.direction = measure::Direction::cw;
  run.feed = 1000 * kMmPerMin;
  run.start = 90;
  run.payload_mass = 20;
  measure::Dataset dataset;
  dataset.machine = "pm600-like";
  dataset.runs = {run};
  const std::string text = measure::dataset_text(dataset);
  CHECK(text.starts_with("plumbline = \"dataset 1\"\nmachine = \"pm600-like\"\n\n[[run]]\nid = \"01-cw\"\n"));
  std::string table = "angle_deg,radial_um\n";
  for (int i = 0; i < 36; ++i) table += std::to_string(350 - 10 * i) + ",0\n";
  scratch.file("01-cw.csv", table);
  const measure::Dataset read = measure::read_dataset(scratch.file("dataset.toml", text));
  CHECK(read.machine == dataset.machine);
  REQUIRE(read.runs.size() == 1);
  CHECK(read.runs[0].centre_W.isApprox(run.centre_W));
  CHECK(read.runs[0].radius == Approx(run.radius));
  CHECK(*read.runs[0].bar == Approx(*run.bar));
  CHECK(read.runs[0].tilt.isApprox(run.tilt));
  CHECK(read.runs[0].direction == run.direction);
  CHECK(read.runs[0].feed == Approx(run.feed));
  CHECK(read.runs[0].start == run.start);
  CHECK(read.runs[0].payload_mass == run.payload_mass);
}

TEST_CASE("a plan's mark is written with its run, and taken out again") {
  measure::Run run;
  run.id = run.file = "a";
  measure::Dataset dataset;
  dataset.runs = {run};
  const std::string plain = measure::dataset_text(dataset);
  dataset.runs[0].planned = measure::table_hash("angle_deg,radial_um\n");
  const std::string planned = measure::dataset_text(dataset);
  CHECK(planned == plain + "planned = \"" + dataset.runs[0].planned + "\"\n");
  CHECK(measure::without_plan(planned) == plain);
  CHECK(measure::without_plan("planned = \"a\"").empty());
  CHECK(measure::without_plan("# planned = \"a\"") == "# planned = \"a\"");
}
