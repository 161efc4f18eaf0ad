// posix.cpp here; windows.cpp and windows_process.cpp are tried by the program itself, under Wine (tests/windows).
#include "base/platform/platform.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/files/descriptor.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace fs = std::filesystem;

namespace {

std::string held_file(const testing::Scratch& scratch, const char* name, Descriptor& file) {
  file = Descriptor(platform::make_held_file(scratch / name, 0600));
  REQUIRE(file.is_open());
  return scratch / name;
}

}  // namespace

TEST_CASE("the status of a file tells what it is, and which") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("part.ngc", "M2\n");
  fs::create_hard_link(path, scratch / "same.ngc");
  const auto status = platform::status_of(path);
  REQUIRE(status);
  CHECK(status->kind == platform::FileKind::file);
  CHECK(status->size == 3);
  CHECK(platform::is_same_file(*status, *platform::status_of(scratch / "same.ngc")));
  CHECK_FALSE(platform::is_same_file(*status, *platform::status_of(scratch.file("other.ngc", "M2\n"))));
  const Descriptor open(platform::open_to_read(path));
  CHECK(platform::is_same_file(*status, *platform::status_of(open.number())));
  CHECK(platform::status_of(scratch.folder().string())->kind == platform::FileKind::folder);
  CHECK(platform::status_of(std::string("/dev/null"))->kind == platform::FileKind::other);
  CHECK_FALSE(platform::status_of(scratch / "none"));
  CHECK(errno == ENOENT);
}

TEST_CASE("a file can be read at any place while another thread appends to it") {
  const testing::Scratch scratch;
  Descriptor file;
  held_file(scratch, "grows", file);
  constexpr int kLines = 20'000;
  std::atomic<int> written = 0;
  std::thread writer([&] {
    for (int i = 0; i < kLines; ++i) {
      const std::string line = std::to_string(1'000'000 + i) + "\n";
      if (platform::append(file.number(), line.data(), line.size()) != 8) return;
      written = i + 1;
    }
  });
  int wrong = 0;
  for (int reads = 0; reads < 5'000 || written < kLines; ++reads) {
    const int lines = written;
    if (lines == 0) continue;
    const int i = reads % lines;
    std::array<char, 8> line{};
    const auto got = platform::read_at(file.number(), line.data(), line.size(), 8 * static_cast<std::uint64_t>(i));
    if (got != 8 || std::string(line.data(), 7) != std::to_string(1'000'000 + i)) ++wrong;
  }
  writer.join();
  CHECK(wrong == 0);
  CHECK(platform::status_of(file.number())->size == 8 * kLines);
  CHECK(platform::empty(file.number()));
  CHECK(platform::append(file.number(), "x", 1) == 1);
  CHECK(platform::status_of(file.number())->size == 1);
}

TEST_CASE("what somebody holds is not swept, and what was left is") {
  const testing::Scratch scratch;
  Descriptor file;
  const std::string path = held_file(scratch, "held", file);
  CHECK(platform::make_held_file(path, 0600) == -1);
  CHECK(errno == EAGAIN);
  platform::remove_if_left(path);
  CHECK(fs::exists(path));
  CHECK(file.close());
  platform::remove_if_left(path);
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("a name takes the place of another, and a second name is the same file") {
  const testing::Scratch scratch;
  const std::string from = scratch.file("from", "new");
  const std::string to = scratch.file("to", "old");
  CHECK(platform::link(to, scratch / "before"));
  CHECK(platform::rename(from, to));
  CHECK(scratch.text("to") == "new");
  CHECK(scratch.text("before") == "old");
  CHECK_FALSE(platform::rename(from, to));
  CHECK(errno == ENOENT);
  CHECK(platform::remove_file(to));
  CHECK_FALSE(platform::remove_file(to));
  fs::create_directory(scratch / "folder");
  CHECK(platform::remove_name((scratch / "folder").c_str()));
  CHECK_FALSE(fs::exists(scratch / "folder"));
}

TEST_CASE("a file takes the permissions of the one that it replaces, whatever the umask") {
  const testing::Scratch scratch;
  const mode_t mask = umask(077);
  const Descriptor file(open((scratch / "new").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  for (const unsigned mode : {0664U, 0755U, 0400U}) {
    platform::FileStatus replaced;
    replaced.mode = mode;
    replaced.owner = geteuid();
    replaced.group = getegid();
    platform::adopt(file.number(), replaced);
    struct stat status {};
    REQUIRE(fstat(file.number(), &status) == 0);
    CHECK((status.st_mode & 07777U) == mode);
  }
  umask(mask);
}

TEST_CASE("arguments and the environment are as they were given") {
  const std::array<const char*, 3> words{"plumbline", "Gehäuse.ngc", "部品.nc"};
  CHECK(platform::arguments_of(3, words.data()) == std::vector<std::string>{"plumbline", "Gehäuse.ngc", "部品.nc"});
  setenv("PLUMBLINE_TEST_VARIABLE", "ä", 1);
  CHECK(platform::environment("PLUMBLINE_TEST_VARIABLE") == "ä");
  unsetenv("PLUMBLINE_TEST_VARIABLE");
  CHECK_FALSE(platform::environment("PLUMBLINE_TEST_VARIABLE"));
}
