#include "base/files/output_set.hpp"

#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostic.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

using Folder = testing::Scratch;

struct Three {
  explicit Three(const Folder& folder) : a(folder / "a"), b(folder / "b"), c(folder / "c") {
    for (OutputFile* const file : {&a, &b, &c}) {
      file->write("new");
      set.add(*file);
    }
  }
  OutputFile a, b, c;
  OutputSet set;
};

}  // namespace

TEST_CASE("files of a set appear together") {
  const Folder folder;
  write_text(folder / "b", "old");
  Three three(folder);
  CHECK_FALSE(fs::exists(folder / "a"));
  CHECK(read_text(folder / "b") == "old");
  three.set.commit();
  for (const char* const name : {"a", "b", "c"}) CHECK(read_text(folder / name) == "new");
  CHECK(folder.entries() == 3);
}

TEST_CASE("where one file cannot appear, the others are as they were") {
  for (const bool clears : {false, true}) {
    const Folder folder;
    write_text(folder / "b", "old");
    {
      Three three(folder);
      fs::create_directory(folder / "c");  // nothing can be renamed to that
      fs::create_directory(folder / "c/d");
      if (clears) three.set.clear_last_first();
      const Diagnostic refused = testing::refusal_of([&] { three.set.commit(); });
      CHECK(refused.code == "file-unwritable");
      CHECK(refused.place.file == folder / "c");
    }
    CHECK_FALSE(fs::exists(folder / "a"));
    CHECK(read_text(folder / "b") == "old");
    CHECK(fs::exists(folder / "c/d"));
    CHECK(folder.entries() == 2);
  }
}

TEST_CASE("the last file goes first where that is asked for, and comes back where another cannot appear") {
  const Folder folder;
  write_text(folder / "c", "old");
  {
    Three three(folder);
    fs::create_directory(folder / "b");
    three.set.clear_last_first();
    CHECK(testing::refusal_of([&] { three.set.commit(); }).code == "file-unwritable");
  }
  CHECK(read_text(folder / "c") == "old");
  CHECK_FALSE(fs::exists(folder / "a"));
  CHECK(folder.entries() == 2);
}

TEST_CASE("a stream gets its bytes before files appear, and files only if it took them") {
  const Folder folder;
  OutputFile file(folder / "a");
  file.write("new");
  {
    OutputFile full("/dev/full");
    full.write("text");
    OutputSet set;
    set.add(file);
    set.add(full);
    CHECK(testing::refusal_of([&] { set.commit(); }).code == "file-unwritable");
  }
  CHECK_FALSE(fs::exists(folder / "a"));
}

TEST_CASE("a folder that was made for a set goes with it") {
  const Folder folder;
  {
    const NewFolder made(folder / "x/y");
    CHECK(fs::is_directory(folder / "x/y"));
  }
  CHECK(folder.entries() == 0);
  fs::create_directory(folder / "x");
  {
    NewFolder kept(folder / "x/y");
    write_text(folder / "x/y/f", "");
    kept.keep();
  }
  CHECK(fs::exists(folder / "x/y/f"));
  CHECK(testing::refusal_of([&] { const NewFolder over(folder / "x/y/f/g"); }).code == "file-unwritable");
}

TEST_CASE("permissions and owner of the file that is replaced are kept; a new one gets what the umask lets through") {
  const Folder folder;
  const std::string name = folder / "part.ngc";
  struct stat status {};
  const mode_t mask = umask(027);
  write_text(name, "old");
  umask(mask);
  REQUIRE(stat(name.c_str(), &status) == 0);
  CHECK((status.st_mode & 07777U) == 0640);
  for (const mode_t mode : {0600, 0664, 0755}) {
    REQUIRE(chmod(name.c_str(), mode) == 0);
    write_text(name, "new");
    REQUIRE(stat(name.c_str(), &status) == 0);
    CHECK((status.st_mode & 07777U) == mode);
  }
  if (geteuid() != 0) return;
  REQUIRE(chown(name.c_str(), 65534, 65534) == 0);
  write_text(name, "newer");
  REQUIRE(stat(name.c_str(), &status) == 0);
  CHECK(status.st_uid == 65534);
  CHECK(status.st_gid == 65534);
}

TEST_CASE("a read-only file is refused, for the superuser too") {
  const Folder folder;
  const std::string name = folder / "part.ngc";
  write_text(name, "old");
  REQUIRE(chmod(name.c_str(), 0444) == 0);
  CHECK(testing::refusal_of([&] { OutputFile file(name); }).code == "file-unwritable");
  CHECK(read_text(name) == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a link that leads to nothing yet stays, and what it leads to is made") {
  const Folder folder;
  fs::create_directory(folder / "d");
  fs::create_symlink("d/real.ngc", folder / "one");
  fs::create_symlink("one", folder / "two");
  write_text(folder / "two", "new");
  CHECK(fs::is_symlink(folder / "one"));
  CHECK(fs::is_symlink(folder / "two"));
  CHECK(read_text(folder / "d/real.ngc") == "new");
  fs::create_symlink("round", folder / "round");
  CHECK(testing::refusal_of([&] { OutputFile file(folder / "round"); }).code == "file-unwritable");
}

TEST_CASE("an open file is written to where it stands, never replaced") {
  const Folder folder;
  const std::string name = folder / "log";
  write_text(name, "begin ");
  struct stat before {};
  REQUIRE(stat(name.c_str(), &before) == 0);
  const int out = open(name.c_str(), O_WRONLY | O_APPEND);
  const int in = open(name.c_str(), O_RDONLY);
  const int own = open(name.c_str(), O_RDWR | O_CLOEXEC);  // as what this process opens for itself
  write_text("/dev/fd/" + std::to_string(out), "end");
  fs::create_symlink("/proc/self/fd/" + std::to_string(out), folder / "link");
  write_text(folder / "link", ".");
  for (const int wrong : {in, own, 987654}) {
    const std::string path = "/dev/fd/" + std::to_string(wrong);
    CHECK(testing::refusal_of([&] { OutputFile file(path); }).code == "file-unwritable");
  }
  for (const int number : {out, in, own}) close(number);
  struct stat after {};
  REQUIRE(stat(name.c_str(), &after) == 0);
  CHECK(after.st_ino == before.st_ino);
  CHECK(read_text(name) == "begin end.");
}

TEST_CASE("what a killed process left is swept, what is in use or another's is not") {
  const Folder folder;
  const std::string left = folder / ".plumbline-0123456789abcdef.tmp";
  const std::string used = folder / ".plumbline-fedcba9876543210.tmp";
  const std::string others = folder / ".plumbline-0123.tmp";
  for (const std::string& name : {left, used, others}) {
    close(open(name.c_str(), O_WRONLY | O_CREAT, 0600));
  }
  const int lock = open(used.c_str(), O_RDONLY);
  REQUIRE(flock(lock, LOCK_EX) == 0);
  write_text(folder / "out", "");
  CHECK_FALSE(fs::exists(left));
  CHECK(fs::exists(used));
  CHECK(fs::exists(others));
  close(lock);
  write_text(folder / "out", "");
  CHECK_FALSE(fs::exists(used));
}

TEST_CASE("a file that is cut, grows or is replaced while it is read is noticed") {
  const Folder folder;
  const std::string name = folder / "in.ngc";
  const auto changed_by = [&](auto&& change) {
    write_text(name, "0123456789");
    const InputFile file(name);
    file.check_unchanged();
    change();
    return testing::refusal_of([&] { file.check_unchanged(); }).code;
  };
  CHECK(changed_by([&] { fs::resize_file(name, 5); }) == "file-changed");
  CHECK(changed_by([&] { fs::resize_file(name, 11); }) == "file-changed");
  CHECK(changed_by([&] { write_text(name, "0123456789"); }) == "file-changed");
  CHECK(changed_by([&] { fs::remove(name); }) == "file-changed");
  CHECK(changed_by([&] { fs::last_write_time(name, fs::last_write_time(name) + std::chrono::seconds(1)); }) ==
        "file-changed");
}
