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
  CHECK(run(scratch, "simulate -d plan/dataset.toml -o sim --no-friction " + kModel).code == 2);
  CHECK(run(scratch, "simulate x.ngc -d plan/dataset.toml -o sim " + kModel).code == 2);
  CHECK(run(scratch, "compare " + kModel).code == 2);
  CHECK(run(scratch, "compare -d plan/dataset.toml --max-radial-um -1 " + kModel).code == 2);
  scratch.file("plan/b.csv", "angle_deg,radial_mm\n");
  const Outcome wrong = run(scratch, "circularity -d plan/dataset.toml");
  CHECK(wrong.code == 1);
  CHECK(contains(wrong.err, "b.csv:1:11:"));
  CHECK(contains(wrong.err, "did you mean `radial_um`"));
}

TEST_CASE("a table of readings is never overwritten") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  const std::string before = scratch.text("plan/a.csv");
  CHECK(run(scratch, "compare -d plan/dataset.toml --json plan/a.csv " + kModel).code == 1);
  CHECK(run(scratch, "circularity -d plan/dataset.toml --json plan/a.csv").code == 1);
  CHECK(scratch.text("plan/a.csv") == before);
}

TEST_CASE("a bound on readings of the bar that nobody made is refused") {
  const Scratch scratch;
  scratch.file("dataset.toml", run_text("a", "ccw", "plumbline = \"dataset 1\"\n"));
  std::string table = "angle_deg,torque1_Nm,torque2_Nm,torque3_Nm,torque4_Nm,torque5_Nm,torque6_Nm\n";
  for (int angle = 0; angle < 360; angle += 10) table += std::to_string(angle) + ",1,1,1,1,1,1\n";
  scratch.file("a.csv", table);
  CHECK(run(scratch, "compare -d dataset.toml " + kModel).code == 0);
  const Outcome outcome = run(scratch, "compare -d dataset.toml --max-radial-um 5 " + kModel);
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "[compare-no-bar]"));
}

TEST_CASE("a diagnosis that fails leaves no folder, and one that works fills it") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  const std::string diagnose = "diagnose -d sim/dataset.toml " + kModel + " ";
  CHECK(run(scratch, diagnose + "-o a/b --without back-lash").code == 1);
  CHECK_FALSE(scratch.has("a"));
  scratch.file("file", "");
  const Outcome in_file = run(scratch, diagnose + "-o file/b");
  CHECK(in_file.code == 1);
  CHECK(contains(in_file.err, "file/b: error: cannot be made a folder"));

  const Outcome done = run(scratch, diagnose + "-o a/b --json");
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK(done.out == scratch.text("a/b/diagnosis.json"));
  CHECK(json::parse(done.out).at("plumbline") == "diagnosis 1");
  CHECK(scratch.text("a/b/report.html").starts_with("<!doctype html>"));
  CHECK(run(scratch, "compare -d sim/dataset.toml -m a/b/model.toml --max-radial-um 0.1").code == 0);
}
