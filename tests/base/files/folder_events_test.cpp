#include "base/files/folder_events.hpp"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"
#include "support/skip.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using Kind = FolderEvent::Kind;
using std::chrono::milliseconds;

TEST_CASE("the system tells of files that come, change and go") {
  const Scratch scratch;
  auto events = FolderEvents::open();
  if (!events) return skip("the system tells nobody of files");
  REQUIRE(events->add(scratch.path("")));
  CHECK(events->wait(milliseconds(1)).empty());
  std::ofstream(scratch.path("a")) << "text";
  auto told = events->wait(milliseconds(5000));
  REQUIRE_FALSE(told.empty());
  CHECK(told.front().kind == Kind::begun);
  CHECK(told.back().kind == Kind::finished);
  CHECK(std::filesystem::path(told.back().path).filename() == "a");
  std::filesystem::rename(scratch.path("a"), scratch.path("b"));
  told = events->wait(milliseconds(5000));
  REQUIRE(told.size() == 2);
  CHECK(told[0].kind == Kind::gone);
  CHECK(told[1].kind == Kind::finished);
  std::filesystem::create_directory(scratch.path("c"));
  told = events->wait(milliseconds(5000));
  REQUIRE(told.size() == 1);
  CHECK(told[0].kind == Kind::folder);
  CHECK_FALSE(events->add(scratch.path("none")));
}
