// What a command was not asked to replace stays, and what it cannot do is said before the work.
#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>

#include "cli/program.hpp"
#include "jobs/dataset_files.hpp"

using namespace plumbline::testing;
namespace fs = std::filesystem;

namespace {

std::string with_offset_given(const std::string& rest) { return "compensate " + rest + " " + kModel + kOffset; }

}  // namespace

TEST_CASE("a posterior is written over that of its model alone") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  const std::string identify = "identify -d sim/dataset.toml " + kModel + " -o ";
  REQUIRE(run(scratch, identify + "m.toml").code == 0);
  CHECK(run(scratch, identify + "m.toml").code == 0);  // its own

  scratch.file("x.posterior.toml", "notes\n");
  const Outcome strange = run(scratch, identify + "x.toml");
  CHECK(strange.code == 1);
  CHECK(contains(strange.err, "[file-exists]"));
  CHECK(scratch.text("x.posterior.toml") == "notes\n");
  CHECK_FALSE(scratch.has("x.toml"));

  // that of the model that is read
  fs::rename(scratch.path("m.toml"), scratch.path("other.toml"));
  const std::string before = scratch.text("m.posterior.toml");
  const Outcome read = run(scratch, "identify -d sim/dataset.toml -m other.toml -o m.toml");
  CHECK(read.code == 1);
  CHECK(contains(read.err, "[file-overwrites-input]"));
  CHECK(contains(run(scratch, identify + "m.toml").err, "[file-exists]"));  // and is no posterior of m.toml
  CHECK(scratch.text("m.posterior.toml") == before);
}

TEST_CASE("behind a link the posterior stands beside the model") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  fs::create_directories(scratch.path("lk"));
  fs::create_symlink("lk/t.toml", scratch.path("link.toml"));
  REQUIRE(run(scratch, "identify -d sim/dataset.toml " + kModel + " -o link.toml").code == 0);
  CHECK(scratch.has("lk/t.posterior.toml"));
  CHECK_FALSE(scratch.has("link.posterior.toml"));
}

TEST_CASE("standard output is one, by whatever name and whatever it is") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  for (const std::string& command :
       {with_offset_given("p.ngc -o /dev/stdout --json -"), with_offset_given("p.ngc -o - --json /dev/fd/1"),
        with_offset_given("p.ngc -o /proc/self/fd/1 --json /dev/stdout"), "map -o /dev/stdout --report - " + kModel}) {
    const Outcome outcome = run(scratch, command + " | cat");
    INFO(command);
    CHECK(outcome.out.empty());
    CHECK(contains(outcome.err, "[file-written-twice]"));
  }
  const Outcome copied = run(scratch, with_offset_given("p.ngc -o - --json /dev/fd/3") + " 3>&1 | cat");
  CHECK(copied.out.empty());
  CHECK(contains(copied.err, "[file-written-twice]"));
  const std::string as_dash = run(scratch, with_offset_given("p.ngc -o -")).out;
  CHECK(run(scratch, with_offset_given("p.ngc -o /dev/stdout")).out == as_dash);
  CHECK(run(scratch, with_offset_given("p.ngc -o /dev/stdout") + " | cat").out == as_dash);
  CHECK(run(scratch, with_offset_given("p.ngc -o - --json /dev/null") + " >/dev/null").code == 0);
  CHECK(run(scratch, "diagnose --json --report /dev/stdout -d d -o e " + kModel).code == 2);
}

TEST_CASE("a model on /dev/stdout has no words among it") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  const Outcome dash = run(scratch, "identify -d sim/dataset.toml -o - " + kModel);
  const Outcome named = run(scratch, "identify -d sim/dataset.toml -o /dev/stdout " + kModel);
  CHECK(dash.code == 0);
  CHECK(named.out == dash.out);
  CHECK(contains(named.err, "friction strut 1"));
}

TEST_CASE("a pipe that nobody named keeps no command waiting") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  REQUIRE(run(scratch, with_offset_given("p.ngc -o o.ngc")).code == 0);
  REQUIRE(std::system(("mkfifo '" + scratch.path("o.ngc.undo") + "'").c_str()) == 0);
  const Outcome outcome = run(scratch, "restore o.ngc -o back.ngc");
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "[undo-format]"));
}

TEST_CASE("options that would be passed over are wrong usage") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  for (const std::string& command :
       {"plan --for tip --separate backlash,servo-lag " + kModel, "plan --seed -1 " + kModel,
        "plan --seed 99999999999999999999999 " + kModel, "plan --radius 0.5 " + kModel, "plan --feed 300000 " + kModel,
        "plan --feed 0.5 " + kModel, "plan --bar 5000 " + kModel, "plan --radius 1e-300 " + kModel,
        with_offset_given("p.ngc -o x --yields time"), "map --box 0,1,0,1,0,nan " + kModel, "map --z nan " + kModel}) {
    const Outcome outcome = run(scratch, command);
    INFO(command << outcome.err);
    CHECK(outcome.code == 2);
  }
}
