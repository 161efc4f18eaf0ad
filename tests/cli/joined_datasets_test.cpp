// Further datasets of a machine, by --with.
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "jobs/dataset_files.hpp"

using namespace plumbline::testing;
using nlohmann::json;

TEST_CASE("further datasets are joined with the first") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  std::filesystem::create_directories(scratch.path("more"));
  for (const char* const name : {"a.csv", "b.csv"}) {
    scratch.file(std::string("more/") + name, shifted(scratch.text(std::string("sim/") + name), 0.3));
  }
  scratch.file("more/dataset.toml", scratch.text("sim/dataset.toml"));
  const std::string both = " -d sim/dataset.toml --with more/dataset.toml " + kModel;

  REQUIRE(run(scratch, "compare --json c.json" + both).code == 0);
  CHECK(json::parse(scratch.text("c.json")).at("runs")[3].at("id") == "b@2");
  CHECK(contains(run(scratch, "inspect" + both).out, "a is a@2, b is b@2"));
  CHECK(contains(run(scratch, "identify -o new.toml --report new.html --force" + both).out, "a is a@2"));
  CHECK(contains(scratch.text("new.toml"), "2 runs) and more/dataset.toml (fnv1a "));
  CHECK(contains(scratch.text("new.html"), "more/dataset.toml (FNV-1a "));
  CHECK(run(scratch, "calibrate -o new.toml --force" + both).code == 0);
  REQUIRE(run(scratch, "plan -n 1 --candidates 20 --for friction --json one.json -d sim/dataset.toml " + kModel).code ==
          0);
  REQUIRE(run(scratch, "plan -n 1 --candidates 20 --for friction --json two.json" + both).code == 0);
  const auto before = [&](const char* file) {
    return json::parse(scratch.text(file)).at("unknowns")[0].at("before").get<double>();
  };
  CHECK(before("two.json") < 0.9 * before("one.json"));
  REQUIRE(run(scratch, "diagnose -o found" + both).code == 0);
  const json datasets = json::parse(scratch.text("found/diagnosis.json")).at("datasets");
  CHECK(datasets[0].at("hash") != datasets[1].at("hash"));
  CHECK(datasets[1].at("file") == "more/dataset.toml");
  CHECK(datasets[1].at("renamed")[0].at("as") == "a@2");
  CHECK(contains(scratch.text("found/report.html"), "more/dataset.toml (FNV-1a "));

  const Outcome missing = run(scratch, "diagnose -o x --with none/dataset.toml -d sim/dataset.toml " + kModel);
  CHECK(missing.code == 1);
  CHECK(contains(missing.err, "none/dataset.toml"));
  CHECK_FALSE(scratch.has("x"));
  CHECK(run(scratch, "compare --json more/a.csv" + both).code == 1);  // a table that is read
  const Outcome alone = run(scratch, "calibrate -o y.toml --poses poses.csv --with more/dataset.toml " + kModel);
  CHECK(alone.code == 2);
  CHECK(contains(alone.err, "there is no -d"));
}
