#include "batch/program_list.hpp"

#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using Names = std::vector<std::string>;

TEST_CASE("programs are known by their endings, in small and large letters") {
  for (const char* const name : {"a.nc", "A.NC", "x/b.ngc", "c.Tap", "d.mpf", "e.MIN", "O1234", "o7"}) {
    INFO(name);
    CHECK(batch::is_program_name(name, {}));
  }
  for (const char* const name : {"a.txt", "plumbline.toml", ".hidden.nc", "O", "Order", "README", "a.nc.undo"}) {
    INFO(name);
    CHECK_FALSE(batch::is_program_name(name, {}));
  }
  CHECK(batch::is_program_name("a.txt", {"txt"}));
  CHECK_FALSE(batch::is_program_name("a.nc", {"txt"}));
}

TEST_CASE("a folder is listed in order, without hidden folders and the folder of outputs") {
  const Scratch scratch;
  for (const char* const folder : {"in/b", "in/.git", "in/out"}) {
    std::filesystem::create_directories(scratch.path(folder));
  }
  for (const char* const name : {"in/z.nc", "in/a.nc", "in/b/c.nc", "in/.git/x.nc", "in/out/y.nc", "in/n.txt"}) {
    scratch.file(name, "G0\n");
  }
  std::filesystem::create_directory_symlink("..", scratch.path("in/b/round"));
  const auto list = batch::list_programs({scratch.path("in"), "", scratch.path("in/out"), {}});
  CHECK(list.programs == Names{scratch.path("in/a.nc"), scratch.path("in/z.nc"), scratch.path("in/b/c.nc")});
  CHECK(list.passed_over == Names{scratch.path("in/b/round"), scratch.path("in/n.txt")});
  CHECK(list.holds_outputs);
  CHECK(list.shut.empty());
  CHECK(list.folders == Names{scratch.path("in"), scratch.path("in/b")});
  CHECK(refusal_of([&] { batch::list_programs({scratch.path("none"), "", "out", {}}); }).code == "batch-folder");
}

TEST_CASE("a list has names on lines, or between zero bytes where names may hold line ends") {
  const Scratch scratch;
  const std::string lines = scratch.file("lines", "a.nc\n\nb c.nc\r\nd.nc");
  CHECK(batch::list_programs({".", lines, "out", {}}).programs == Names{"a.nc", "b c.nc", "d.nc"});
  const std::string zeros = scratch.file("zeros", std::string("a\nb.nc\0c.nc\0", 12));
  CHECK(batch::list_programs({".", zeros, "out", {}}).programs == Names{"a\nb.nc", "c.nc"});
}

TEST_CASE("the place of a program is in its folder, or it is refused") {
  CHECK(batch::place_in_folder("in", "in/a/b.nc") == "a/b.nc");
  CHECK(batch::place_in_folder("in/", "./in/x/../b.nc") == "b.nc");
  CHECK(batch::place_in_folder(".", "a/b.nc") == "a/b.nc");
  CHECK(batch::place_in_folder(".", std::filesystem::absolute("a/b.nc").string()) == "a/b.nc");
  CHECK(batch::place_in_folder("in", "in/..b.nc") == "..b.nc");
  CHECK(refusal_of([] { batch::place_in_folder("in", "other/b.nc"); }).code == "batch-outside");
  CHECK(refusal_of([] { batch::place_in_folder("in", "in"); }).code == "batch-outside");
}
