#include "jobs/circularity.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "jobs/dataset_files.hpp"
#include "report/measured/circularity_text.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("every run and every pair of directions has its figures") {
  const Scratch scratch;
  const std::string plan = scratch.file("plan/dataset.toml", plan_text(scratch));
  scratch.file("plan/a.csv", shifted(scratch.text("plan/a.csv"), 3));  // readings of 3 um; those of b are 0
  const jobs::CircularityTable table = jobs::circularity_table(measure::read_dataset(plan));
  REQUIRE(table.runs.size() == 2);
  CHECK(table.runs[0].figures.minimum_zone == Approx(0).margin(1e-12));
  CHECK(table.runs[0].figures.radial_max == Approx(3e-6));
  CHECK(table.runs[0].harmonics.size() == 8);
  REQUIRE(table.pairs.size() == 1);
  CHECK(table.pairs[0].ccw == "a");
  CHECK(table.pairs[0].cw == "b");
  CHECK(table.pairs[0].figures.minimum_zone == Approx(3e-6));
  CHECK(table.pairs[0].figures.mean_radial == Approx(1.5e-6));

  const auto json = nlohmann::json::parse(report::circularity_json(table));
  CHECK(json["runs"][0]["F_max_um"].get<double>() == Approx(3));
  CHECK(json["pairs"][0]["D_um"].get<double>() == Approx(1.5));
  const std::string text = report::circularity_text(table);
  CHECK(text.find("a, b ") != std::string::npos);
  CHECK(text.find("1.50\n") != std::string::npos);
}

TEST_CASE("figures that round to zero have no sign") {
  jobs::CircularityTable table;
  table.runs.push_back(
      {"a", {.least_squares = 1e-9, .minimum_zone = -1e-9, .radial_max = -1e-10, .radial_min = -4e-9}, {}});
  table.pairs.push_back({"a", "b", {.minimum_zone = -1e-9, .mean_radial = -1.5e-6}});
  const std::string text = report::circularity_text(table);
  CHECK(text.find("-0.00") == std::string::npos);
  CHECK(text.find("-1.50\n") != std::string::npos);
}

TEST_CASE("runs at other tilts are no pair") {
  const Scratch scratch;
  std::string text = plan_text(scratch);
  text.replace(text.rfind("[-25, 0, 0]"), 11, "[-24, 0, 0]");
  const jobs::CircularityTable table =
      jobs::circularity_table(measure::read_dataset(scratch.file("plan/dataset.toml", text)));
  CHECK(table.runs.size() == 2);
  CHECK(table.pairs.empty());
  CHECK(report::circularity_text(table).find("directions") == std::string::npos);
}
