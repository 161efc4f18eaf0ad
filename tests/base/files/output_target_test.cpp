// Links, permissions and numbers of open files as outputs take them are in output_set_test.cpp.
#include "base/files/output_target.hpp"

#include <filesystem>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/files/descriptor.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

TEST_CASE("a name that is free leads to a new file in its folder") {
  const testing::Scratch scratch;
  const OutputTarget target = output_target(scratch / "out.ngc");
  CHECK(target.kind == OutputTarget::Kind::file);
  CHECK(target.path == scratch / "out.ngc");
  CHECK(target.folder() == scratch.folder().string());
  CHECK_FALSE(target.replaced);
  CHECK(output_target("no-such-file.ngc").folder() == ".");
}

TEST_CASE("a file that stands there tells what it is replaced with") {
  const testing::Scratch scratch;
  const std::string name = scratch.file("part.ngc", "old");
  REQUIRE(chmod(name.c_str(), 0640) == 0);
  fs::create_directory(scratch / "links");
  fs::create_symlink("../part.ngc", scratch / "links/here");
  const OutputTarget target = output_target(scratch / "links/here");
  CHECK(target.kind == OutputTarget::Kind::file);
  CHECK(fs::equivalent(target.path, name));
  REQUIRE(target.replaced);
  CHECK(target.replaced->mode == 0640U);
  CHECK(target.replaced->owner == geteuid());
}

TEST_CASE("standard output, a device and a pipe are written to") {
  const testing::Scratch scratch;
  const OutputTarget standard = output_target("-");
  CHECK(standard.kind == OutputTarget::Kind::descriptor);
  CHECK(standard.descriptor == STDOUT_FILENO);
  CHECK(output_target("/dev/null").kind == OutputTarget::Kind::device);
  REQUIRE(mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  CHECK(output_target(scratch / "pipe").kind == OutputTarget::Kind::device);
  const Descriptor open_for_it(dup(STDOUT_FILENO));  // not closed on exec: as a shell leaves 3>file
  const OutputTarget number = output_target("/dev/fd/" + std::to_string(open_for_it.number()));
  CHECK(number.kind == OutputTarget::Kind::descriptor);
  CHECK(number.descriptor == open_for_it.number());
}

TEST_CASE("what is no place for an output is refused with the reason") {
  const testing::Scratch scratch;
  CHECK(testing::refusal_of([&] { output_target(scratch.folder().string()); }).code == "file-is-folder");
  const std::string read_only = scratch.file("part.ngc", "old");
  REQUIRE(chmod(read_only.c_str(), 0444) == 0);
  CHECK(testing::refusal_of([&] { output_target(read_only); }).message == "is read-only");
  fs::create_symlink("round", scratch / "round");
  CHECK(testing::refusal_of([&] { output_target(scratch / "round"); }).message ==
        "leads from link to link without an end");
  CHECK(testing::refusal_of([] { output_target("/dev/fd/99999"); }).message == "is no open file");
  CHECK(testing::refusal_of([] { output_target("/dev/fd/one"); }).message == "is no open file");
}
