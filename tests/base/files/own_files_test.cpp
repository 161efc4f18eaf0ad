#include "base/files/own_files.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("an output is no input, whatever it is called") {
  const testing::Scratch scratch;
  const std::string in = scratch.file("in.ngc", "G0\n");
  std::filesystem::create_symlink(in, scratch.path("link.ngc"));
  refuse_shared_files({in, ""}, {scratch.path("out.ngc"), ""});
  CHECK(testing::refusal_of([&] { refuse_shared_files({in}, {in}); }).code == "file-overwrites-input");
  CHECK(testing::refusal_of([&] { refuse_shared_files({in}, {scratch.path("link.ngc")}); }).code ==
        "file-overwrites-input");
}

TEST_CASE("two outputs are two files, even those that are not there yet") {
  const testing::Scratch scratch;
  const std::string out = scratch.path("out.ngc");
  CHECK(testing::refusal_of([&] {
          refuse_shared_files({}, {out, scratch.path("./out.ngc")});
        }).code == "file-written-twice");
  refuse_shared_files({}, {out, scratch.path("out2.ngc")});
}
