// The commands that work on measurements.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "jobs/dataset_files.hpp"

using namespace plumbline::testing;
using nlohmann::json;

TEST_CASE("simulate, compare and circularity work on a dataset") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  const Outcome simulated = run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel);
  CHECK(simulated.code == 0);
  CHECK(simulated.out.empty());
  CHECK(contains(simulated.err, "2 runs, 240 samples"));

  const Outcome compared = run(scratch, "compare -d sim/dataset.toml --json c.json --max-radial-um 0.01 " + kModel);
  CHECK(compared.code == 0);
  CHECK(contains(compared.out, "radial rms um"));
  CHECK(json::parse(scratch.text("c.json")).at("radial_rms_um").get<double>() < 0.001);
  const Outcome apart = run(scratch, "compare -d plan/dataset.toml --json - --max-radial-um 5 " + kModel);
  CHECK(apart.code == 1);
  CHECK(json::parse(apart.out).at("runs").size() == 2);

  const Outcome figures = run(scratch, "circularity -d sim/dataset.toml --json f.json");
  CHECK(figures.code == 0);
  CHECK(contains(figures.out, "G(b)"));
  CHECK(json::parse(scratch.text("f.json")).at("runs")[0].at("circularity_um").get<double>() > 200);
}

TEST_CASE("what the commands on measurements are not told is wrong usage, what is wrong with a dataset fails") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  CHECK(run(scratch, "simulate -d plan/dataset.toml " + kModel).code == 2);
  CHECK(run(scratch, "simulate -d plan/dataset.toml -o sim").code == 2);
  CHECK(run(scratch, "simulate x.ngc -d plan/dataset.toml -o sim " + kModel).code == 2);
  CHECK(run(scratch, "compare " + kModel).code == 2);
  CHECK(run(scratch, "compare -d plan/dataset.toml --max-radial-um -1 " + kModel).code == 2);
  scratch.file("plan/b.csv", "angle_deg,radial_mm\n");
  const Outcome wrong = run(scratch, "circularity -d plan/dataset.toml");
  CHECK(wrong.code == 1);
  CHECK(contains(wrong.err, "b.csv:1:11:"));
  CHECK(contains(wrong.err, "did you mean `radial_um`"));
}
