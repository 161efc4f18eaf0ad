#include "jobs/measured/paper.hpp"

#include <catch2/catch.hpp>

#include "jobs/dataset_files.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("a paper says whose machine it was, who measured, and which files it rests on") {
  const Scratch scratch;
  const std::string plain = scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string model = source_file("models/pm600-like.toml");
  const jobs::Paper before = jobs::paper_of(plain, {model, ""});
  CHECK(before.machine == "pm600-like");
  CHECK(before.protocol.rows().empty());
  REQUIRE(before.files.size() == 2);
  CHECK(before.files[1].what == "model");
  CHECK(before.figures.runs.size() == 2);

  std::string text = scratch.text("plan/dataset.toml");
  text.insert(text.find("\n[[run]]"), "[protocol]\nserial = \"0042\"\noperator = \"E. Maier\"\ndate = 2026-11-24\n");
  const jobs::Paper after = jobs::paper_of(scratch.file("plan/dataset.toml", text), {model});
  CHECK(after.protocol.serial == "0042");
  CHECK(after.protocol.operator_ == "E. Maier");
  CHECK(after.protocol.date == "2026-11-24");
  CHECK(after.files[0].hash != before.files[0].hash);
  CHECK(after.files[1].hash == before.files[1].hash);
  // the tables count, too
  scratch.file("plan/a.csv", shifted(scratch.text("plan/a.csv"), 1));
  CHECK(jobs::paper_of(plain, {}).files[0].hash != after.files[0].hash);
  CHECK(jobs::paper_of("/dev/null", {}).files.empty());
}
