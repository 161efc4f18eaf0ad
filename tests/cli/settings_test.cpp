#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;
using nlohmann::json;

namespace {

// Two machines in a file above the folder of a program.
void write_shop(const Scratch& scratch) {
  std::filesystem::create_directories(scratch.path("jobs"));
  scratch.file("jobs/part.ngc", kPart);
  scratch.file("plumbline.toml", "plumbline = \"settings 1\"\nmachine = \"hex-3\"\n[machines.hex-3]\nmodel = \"" +
                                     source_file("models/pm600-like.toml") +
                                     "\"\noutput_name = \"{folder}/{name}_{machine}{ext}\"\n"
                                     "[machines.hex-3.work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n"
                                     "[machines.hex-4]\nmodel = \"hex-4.toml\"\n");
}

}  // namespace

TEST_CASE("one word is enough where settings say the rest") {
  const Scratch scratch;
  write_shop(scratch);
  const Outcome outcome = run(scratch, "compensate jobs/part.ngc");
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "  machine               hex-3\n"));
  CHECK(contains(outcome.err, "/plumbline.toml\n"));
  CHECK(contains(outcome.err, "  output                jobs/part_hex-3.ngc\n"));
  const std::string written = scratch.text("jobs/part_hex-3.ngc");
  CHECK(contains(written, "(machine hex-3)"));
  CHECK(run(scratch, "compensate jobs/part.ngc -o named.ngc").code == 0);
  CHECK(scratch.text("named.ngc") == written);
  CHECK(run(scratch, "compensate jobs/part.ngc").code == 0);  // over what it wrote before
}

TEST_CASE("an output that nobody named is written over no other file") {
  const Scratch scratch;
  write_shop(scratch);
  scratch.file("jobs/part_hex-3.ngc", kPart);
  const Outcome outcome = run(scratch, "compensate jobs/part.ngc");
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "[file-exists]"));
  CHECK(scratch.text("jobs/part_hex-3.ngc") == kPart);
  const Outcome itself = run(scratch, "compensate jobs/part.ngc --output-name {folder}/{name}{ext}");
  CHECK(itself.code == 1);
  CHECK(scratch.text("jobs/part.ngc") == kPart);
  CHECK(run(scratch, "compensate jobs/part.ngc --output-name out.ngc").code == 2);
  CHECK(run(scratch, "compensate jobs/part.ngc --output-name '{folder}/{nam}'").code == 2);
}

TEST_CASE("without a pattern the output is named after its program, and standard input goes to standard output") {
  const Scratch scratch;
  scratch.file("part.ngc", kPart);
  CHECK(run(scratch, "compensate part.ngc " + kModel + kOffset).code == 0);
  const Outcome piped = run(scratch, "compensate - " + kModel + kOffset + "< part.ngc");
  CHECK(piped.code == 0);
  CHECK(piped.out == scratch.text("part_straight.ngc"));
  const Outcome nameless = run(scratch, "compensate part.ngc --output-name '{name}_{machine}' " + kModel + kOffset);
  CHECK(nameless.code == 2);
  CHECK(contains(nameless.err, "--machine NAME"));
}

TEST_CASE("settings says what holds and where it is stated") {
  const Scratch scratch;
  write_shop(scratch);
  const Outcome outcome = run(scratch, "settings jobs/part.ngc --step-length 0.5");
  INFO(outcome.out);
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "machine hex-3, as "));
  CHECK(contains(outcome.out, "/plumbline.toml:2 says\n"));
  CHECK(contains(outcome.out, "G54=0,0,-1008,0,0,0"));
  CHECK(contains(outcome.out, "/plumbline.toml:7\n"));
  CHECK(contains(outcome.out, "the command line\n"));
  CHECK(contains(outcome.out, "output where -o does not say: jobs/part_hex-3.ngc\n"));
  const Outcome as_json = run(scratch, "settings jobs/part.ngc --machine hex-4 --json -");
  const json said = json::parse(as_json.out);
  CHECK(said.at("plumbline") == "resolved settings 1");
  CHECK(said.at("machine") == "hex-4");
  CHECK(said.at("machines") == json({"hex-3", "hex-4"}));
  CHECK(said.at("output") == "jobs/part_straight.ngc");
  REQUIRE(said.at("options").size() == 1);
  CHECK(said.at("options")[0].at("name") == "model");
  CHECK(said.at("options")[0].at("line") == 9);
  const Outcome none = run(scratch, "settings --no-settings");
  CHECK(none.code == 0);
  CHECK(contains(none.out, "nothing is stated"));
  const Outcome unknown = run(scratch, "settings jobs/part.ngc --machine hex3");
  CHECK(unknown.code == 1);
  CHECK(contains(unknown.err, "did you mean hex-3?"));
}

TEST_CASE("settings come from the file that PLUMBLINE_SETTINGS names, and from the user's own") {
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("own/plumbline"));
  scratch.file("own/plumbline/plumbline.toml", "plumbline = \"settings 1\"\nstep_length = 2\nstep_angle = 2\n");
  scratch.file("named.toml", "plumbline = \"settings 1\"\nstep_length = 3\n");
  const Outcome outcome = run(scratch, "settings", "XDG_CONFIG_HOME=own PLUMBLINE_SETTINGS=named.toml");
  INFO(outcome.out);
  CHECK(contains(outcome.out, "step-angle   2  own/plumbline/plumbline.toml:3\n"));
  CHECK(contains(outcome.out, "step-length  3  named.toml:2\n"));
  const Outcome missing = run(scratch, "settings", "PLUMBLINE_SETTINGS=missing.toml");
  CHECK(missing.code == 1);
  CHECK(missing.err.starts_with("missing.toml: error: "));
}

TEST_CASE(
    "settings: a slip in a key is told with the key that is near, and machines that are not chosen with their names") {
  const Scratch scratch;
  scratch.file("part.nc", kPart);
  scratch.file("plumbline.toml", "plumbline = \"settings 1\"\nstep-angle = 1\n");
  CHECK(contains(run(scratch, "compensate part.nc").err, "did you mean step_angle? settings are"));
  scratch.file("plumbline.toml", "plumbline = \"settings 1\"\n[machines.hex-3]\nmodel = \"m.toml\"\n");
  CHECK(contains(run(scratch, "compensate part.nc").err, "--machine NAME takes one of hex-3"));
  CHECK(contains(run(scratch, "batch . -o out").err, "--machine NAME takes one of hex-3"));
}
