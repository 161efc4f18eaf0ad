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

TEST_CASE("identify writes a model that fits, and says what it learnt") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  std::string other = plumbline::read_text(source_file("models/pm600-like.toml"));
  const std::string friction = "coulomb_friction_N = [110";
  other.replace(other.find(friction), friction.size(), "coulomb_friction_N = [121");
  scratch.file("other.toml", other);
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim -m other.toml").code == 0);

  const Outcome found = run(scratch, "identify -d sim/dataset.toml -o new.toml --json new.json " + kModel);
  CHECK(found.code == 0);
  CHECK(contains(found.out, "friction strut 1"));
  CHECK(contains(found.out, "circles at one height"));
  CHECK(contains(scratch.text("new.toml"), "# Identified by plumbline"));
  const json result = json::parse(scratch.text("new.json"));
  CHECK(result.at("converged") == true);
  CHECK(result.at("gap").at("after").at("radial_rms_um").get<double>() < 0.01);
  CHECK(run(scratch, "compare -d sim/dataset.toml -m new.toml --max-radial-um 0.01").code == 0);

  CHECK(run(scratch, "identify -d sim/dataset.toml " + kModel).code == 2);
  CHECK(run(scratch, "identify -d sim/dataset.toml -o x.toml --stages both " + kModel).code == 2);
  const Outcome unknown = run(scratch, "identify -d sim/dataset.toml -o x.toml --free backlash.witdh_um " + kModel);
  CHECK(unknown.code == 1);
  CHECK(contains(unknown.err, "did you mean backlash.width_um?"));
  CHECK(run(scratch, "identify -d sim/dataset.toml -o sim/dataset.toml " + kModel).code == 1);
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
