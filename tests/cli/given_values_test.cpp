// What application/given_values.hpp refuses, seen from the command line.
#include <string>

#include <catch2/catch.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;

namespace {

std::string compensating(const std::string& rest) { return "compensate " + rest + " " + kModel + kOffset; }

}  // namespace

TEST_CASE("results replace nothing of another kind") {
  const Scratch scratch;
  scratch.file("a.ngc", kPart);
  scratch.file("p.ngc", kPart);
  for (const char* const option : {"--json", "--report", "--depfile"}) {
    const Outcome outcome = run(scratch, compensating(std::string("p.ngc -o x ") + option + " a.ngc"));
    INFO(option);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "a.ngc stands there already, and is not "));
    CHECK(scratch.text("a.ngc") == kPart);
    CHECK_FALSE(scratch.has("x"));
    for (int again = 0; again < 2; ++again)  // its own file it replaces
      CHECK(run(scratch, compensating(std::string("p.ngc -o y ") + option + " r" + option)).code == 0);
    scratch.file("empty", "");
    CHECK(run(scratch, compensating(std::string("p.ngc -o y ") + option + " empty")).code == 0);
  }
}

TEST_CASE("a value behind -o= is no file of that name") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome outcome = run(scratch, compensating("p.ngc -o=x.ngc"));
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, "write -o x.ngc"));
  CHECK_FALSE(scratch.has("=x.ngc"));
  CHECK(run(scratch, compensating("p.ngc --output=x.ngc")).code == 0);
}
