#include "nc/sequence/call_stack.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::ProgramFile;

TEST_CASE("a call of several passes begins again until none remains, and tells the steps which one it is") {
  const ProgramFile program("G0 X1\n");
  const InputFile file(program.path());
  const ProgramFiles files(file, dialect("linuxcnc"));
  CallStack calls(2);
  CHECK(calls.empty());
  calls.push({.name = "100", .by = CalledBy::code, .remaining = 2, .line = 7});
  CHECK(calls.entry(files).name == "100");
  CHECK(calls.entry(files).line == 7);
  CHECK(calls.entry(files).pass == 1);
  CHECK(calls.entry(files).file.empty());
  CHECK(calls.begins_again());
  CHECK(calls.begins_again());
  CHECK(calls.entry(files).pass == 3);
  CHECK_FALSE(calls.begins_again());
  calls.pop();
  CHECK(calls.empty());
}

TEST_CASE("one call more than the control takes is refused") {
  CallStack calls(2);
  const Block block;
  calls.push({.name = "a"});
  calls.check_room(block);
  calls.push({.name = "b"});
  CHECK(calls.depth() == 2);
  CHECK_THROWS_AS(calls.check_room(block), Refusal);
}
