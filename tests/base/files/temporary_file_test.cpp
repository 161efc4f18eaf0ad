// What is swept when an output is opened is in output_set_test.cpp.
#include "base/files/temporary_file.hpp"

#include <cerrno>
#include <filesystem>
#include <regex>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/files/folder_lock.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

TEST_CASE("passing names have one form and are never the same") {
  const std::string one = fs::path(passing_name_in("/folder")).filename().string();
  CHECK(std::regex_match(one, std::regex("[.]plumbline-[0-9a-f]{16}[.]tmp")));
  CHECK(fs::path(passing_name_in("/folder")).parent_path() == "/folder");
  CHECK(passing_name_in("/folder") != passing_name_in("/folder"));
}

TEST_CASE("a temporary file is written and read, locked, and gone with its name") {
  const testing::Scratch scratch;
  std::string path;
  {
    const std::optional<TemporaryFile> made = make_temporary_file(scratch.folder().string(), 0600);
    REQUIRE(made);
    path = made->name.path();
    CHECK(fs::path(path).parent_path() == scratch.folder());
    CHECK(write_all(made->descriptor.number(), "text", 4));
    char text[4] = {};
    CHECK(pread(made->descriptor.number(), text, 4, 0) == 4);
    const Descriptor other(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    CHECK(flock(other.number(), LOCK_EX | LOCK_NB) == -1);
    struct stat status {};
    REQUIRE(fstat(other.number(), &status) == 0);
    CHECK((status.st_mode & 0777U) == 0600);
  }
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("in a folder that is not there none is made, with the reason") {
  const testing::Scratch scratch;
  CHECK_FALSE(make_temporary_file(scratch / "none", 0600));
  CHECK(errno == ENOENT);
  CHECK_NOTHROW(sweep_temporary_files(scratch / "none"));
}

TEST_CASE("only what nobody holds is swept, and no folder, link or file of another name") {
  const testing::Scratch scratch;
  const std::string folder = scratch.folder().string();
  const std::optional<TemporaryFile> used = make_temporary_file(folder, 0600);
  REQUIRE(used);
  const std::string left = scratch.file(".plumbline-00000000000000aa.tmp", "left");
  const std::string upper = scratch.file(".plumbline-00000000000000AA.tmp", "not ours");
  fs::create_directory(scratch / ".plumbline-00000000000000bb.tmp");
  fs::create_symlink(scratch.file("part", ""), scratch / ".plumbline-00000000000000cc.tmp");
  scratch.file(".plumbline-00000000000000dd.tmp", "left");
  {
    const FolderLock busy(folder, FolderLock::Kind::exclusive);
    sweep_temporary_files(folder);
    CHECK(scratch.has(".plumbline-00000000000000dd.tmp"));  // others' outputs appear just now
  }
  sweep_temporary_files(folder);
  CHECK_FALSE(fs::exists(left));
  CHECK_FALSE(scratch.has(".plumbline-00000000000000dd.tmp"));
  CHECK(fs::exists(used->name.path()));
  CHECK(fs::exists(upper));
  CHECK(scratch.has(".plumbline-00000000000000bb.tmp"));
  CHECK(scratch.has(".plumbline-00000000000000cc.tmp"));
}

TEST_CASE("an unnamed file is open for both, and closes on exec") {
  const Descriptor file = open_unnamed_temporary();
  CHECK(write_all(file.number(), "hello", 5));
  char text[5] = {};
  CHECK(pread(file.number(), text, 5, 0) == 5);
  CHECK(std::string(text, 5) == "hello");
  CHECK((fcntl(file.number(), F_GETFD) & FD_CLOEXEC) != 0);
}
