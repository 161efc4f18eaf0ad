#include "base/files/output_group.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "base/text/hash.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("outputs of a group appear whole, as they were known before") {
  const Scratch scratch;
  scratch.file("a", "old");
  std::filesystem::permissions(scratch.path("a"), std::filesystem::perms::owner_all);
  WaitingOutput a(scratch.path("a"));
  WaitingOutput b(scratch.path("b"));
  a.destination().taker()("ne");
  a.destination().taker()("w");
  b.destination().taker()("");
  CHECK(a.hash() == fnv1a("new"));
  CHECK(a.size() == 3);
  OutputGroup group;
  group.add(a);
  group.add(b);
  group.make_last();
  CHECK(scratch.text("a") == "old");
  CHECK_FALSE(scratch.has("b"));
  const auto state = a.state();
  group.appear();
  CHECK_FALSE(group.problem(a));
  CHECK(scratch.text("a") == "new");
  CHECK(scratch.has("b"));
  CHECK(file_state(scratch.path("a")) == state);
  CHECK((std::filesystem::status(scratch.path("a")).permissions() & std::filesystem::perms::owner_exec) ==
        std::filesystem::perms::owner_exec);
  CHECK(scratch.entries() == 2);
}

TEST_CASE("what does not appear leaves nothing, and is no hindrance to the others") {
  const Scratch scratch;
  { const WaitingOutput given_up(scratch.path("a")); }
  CHECK(scratch.entries() == 0);
  WaitingOutput blocked(scratch.path("b"));
  WaitingOutput c(scratch.path("c"));
  std::filesystem::create_directory(scratch.path("b"));
  OutputGroup group;
  group.add(blocked);
  group.add(c);
  group.make_last();
  group.appear();
  REQUIRE(group.problem(blocked));
  CHECK(group.problem(blocked)->code == "file-unwritable");
  CHECK_FALSE(group.problem(c));
  CHECK(scratch.has("c"));
}

TEST_CASE("an output that is no file, or has no folder, is refused") {
  const Scratch scratch;
  CHECK(refusal_of([&] { WaitingOutput(scratch.path("no/a")); }).code == "file-unwritable");
  CHECK(refusal_of([] { WaitingOutput("-"); }).code == "file-unwritable");
  CHECK(refusal_of([] { WaitingOutput("/dev/null"); }).code == "file-unwritable");
}
