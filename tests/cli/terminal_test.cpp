// What a terminal is shown beside the words: tried on a pseudo-terminal, that of script (util-linux, bsdutils).
#include <catch2/catch.hpp>

#include "cli/program.hpp"
#include "jobs/dataset_files.hpp"

using namespace plumbline::testing;

namespace {

// Standard output and standard error as they arrive at a terminal.
std::string on_terminal(const Scratch& scratch, const std::string& arguments, const std::string& environment = "") {
  const std::string command = "cd '" + scratch.path("") + "' && script -qec \"env -u NO_COLOR TERM=xterm " +
                              environment + " '" + program() + "' " + arguments +
                              "\" /dev/null </dev/null >terminal.txt 2>&1";
  [[maybe_unused]] const int status = std::system(command.c_str());
  return scratch.text("terminal.txt");
}

constexpr const char* kRed = "\x1b[1m\x1b[31m";
constexpr const char* kGreen = "\x1b[1m\x1b[32m";

bool has_colour(const std::string& text) { return contains(text, "\x1b["); }

}  // namespace

TEST_CASE("verdicts are coloured on a terminal, and nowhere else") {
  const Scratch scratch;
  scratch.file("good.ngc", kPart);
  scratch.file("bad.ngc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 A26.5 F1000\nM2\n");
  scratch.file("wrong.ngc", "G0 Q\n");
  const std::string options = kModel + kOffset;
  CHECK(contains(on_terminal(scratch, "check good.ngc " + options), kGreen + std::string("all kept\x1b[0m")));
  CHECK(contains(on_terminal(scratch, "check bad.ngc " + options), kRed + std::string("beyond its limit in\x1b[0m")));
  CHECK(contains(on_terminal(scratch, "check wrong.ngc " + options), kRed + std::string("error:\x1b[0m")));
  const Outcome piped = run(scratch, "check bad.ngc " + options, "TERM=xterm");
  CHECK(contains(piped.out, "beyond its limit in"));
  CHECK_FALSE(has_colour(piped.out));
  CHECK_FALSE(has_colour(run(scratch, "check wrong.ngc " + options, "TERM=xterm").err));
}

TEST_CASE("NO_COLOR, a dumb terminal and messages in JSON have no colours") {
  const Scratch scratch;
  scratch.file("wrong.ngc", "G0 Q\n");
  const std::string check = "check wrong.ngc " + kModel + kOffset;
  CHECK(has_colour(on_terminal(scratch, check)));
  CHECK(has_colour(on_terminal(scratch, check, "NO_COLOR=")));
  CHECK_FALSE(has_colour(on_terminal(scratch, check, "NO_COLOR=1")));
  CHECK_FALSE(has_colour(on_terminal(scratch, check, "TERM=dumb")));
  CHECK_FALSE(has_colour(on_terminal(scratch, check + " --diagnostics=json")));
}

TEST_CASE("a diagnosis says on a terminal what it is at, its figures with -v alone, and coloured what it found") {
  const Scratch scratch;
  scratch.file("plan/dataset.toml", plan_text(scratch));
  REQUIRE(run(scratch, "simulate -d plan/dataset.toml -o sim " + kModel).code == 0);
  const std::string diagnose = "diagnose -d sim/dataset.toml -o out " + kModel;
  const std::string seen = on_terminal(scratch, diagnose);
  CHECK(contains(seen, "diagnose: looking at the readings of 2 runs"));
  CHECK(contains(seen, kGreen + std::string("nothing-missing")));
  CHECK_FALSE(contains(seen, "threshold"));
  CHECK_FALSE(contains(on_terminal(scratch, diagnose + " -q"), "looking at"));
  CHECK(contains(run(scratch, diagnose + " -v").err, "threshold"));
  CHECK(run(scratch, diagnose).err.empty());
}

TEST_CASE("quiet leaves errors, warnings and results, and verbose adds the steps") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const std::string compensate = "compensate p.ngc " + kModel + kOffset + " -o out.ngc";
  CHECK(contains(run(scratch, compensate).err, "largest correction"));
  CHECK(run(scratch, compensate + " -q").err.empty());
  CHECK(run(scratch, "-q " + compensate).err.empty());
  CHECK(contains(run(scratch, "check p.ngc -q " + kModel + kOffset).out, "all kept"));
  CHECK(contains(run(scratch, "compensate missing.ngc -q -o out.ngc " + kModel).err, "error:"));
  scratch.file("plumbline.toml", "plumbline = \"settings 1\"\n");
  CHECK_FALSE(contains(run(scratch, compensate).err, "settings: "));
  CHECK(contains(run(scratch, compensate + " -v").err, "settings: plumbline.toml"));
  const Outcome both = run(scratch, compensate + " -q -v");
  CHECK(both.code == 2);
  CHECK(contains(both.err, "--quiet excludes --verbose"));
}
