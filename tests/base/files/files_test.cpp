#include "base/files/files.hpp"

#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostic.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

using Folder = testing::Scratch;

std::string code_of(auto&& action) {
  try {
    action();
  } catch (const Refusal& refusal) {
    return refusal.diagnostic().code;
  }
  return "";
}

}  // namespace

TEST_CASE("output appears whole at commit and not before") {
  const Folder folder;
  const std::string name = folder / "out.txt";
  {
    OutputFile file(name);
    file.write("half");
    CHECK_FALSE(fs::exists(name));
  }
  CHECK(fs::is_empty(folder.folder()));  // no commit: nothing is left, the temporary file neither
  write_text(name, "whole\n");
  CHECK(read_text(name) == "whole\n");
  CHECK(std::distance(fs::directory_iterator(folder.folder()), fs::directory_iterator()) == 1);
}

TEST_CASE("input is read at any offset, and knows itself by another name") {
  const Folder folder;
  const std::string name = folder / "in.txt";
  write_text(name, "0123456789");
  const InputFile file(name);
  char two[2];
  CHECK(file.read(4, two, 2) == 2);
  CHECK(std::string(two, 2) == "45");
  CHECK(file.read(9, two, 2) == 1);
  CHECK(file.read(10, two, 2) == 0);
  fs::create_symlink(name, folder / "link");
  CHECK(file.is_same_as(folder / "link"));
  CHECK_FALSE(file.is_same_as(folder / "other"));
}

TEST_CASE("files that cannot be had are refused by name") {
  const Folder folder;
  CHECK(code_of([&] { InputFile file(folder / "none"); }) == "file-missing");
  CHECK(code_of([&] { InputFile file(folder.folder().string()); }) == "file-is-folder");
  CHECK(code_of([&] { OutputFile file(folder.folder().string()); }) == "file-is-folder");
  CHECK(code_of([&] { OutputFile file(folder / "none/out.txt"); }) == "file-unwritable");
}

TEST_CASE("output through a link replaces the file that it leads to, and leaves the link") {
  const Folder folder;
  const std::string name = folder / "part.ngc";
  write_text(name, "old");
  fs::create_symlink(name, folder / "link");
  write_text(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_text(name) == "new");
}

TEST_CASE("a file far too large for a text is refused before it is read") {
  const Folder folder;
  const std::string name = folder / "huge.csv";
  write_text(name, "");
  fs::resize_file(name, 2'000'000'000);  // takes no room: nothing is written
  CHECK(code_of([&] { read_text(name); }) == "file-too-large");
  CHECK(InputFile(name).size() == 2'000'000'000);
}

TEST_CASE("a folder for temporary files that is not there is refused, and nothing stays open") {
  const auto open_files = [] {
    return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
  };
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  const auto open_before = open_files();
  setenv("TMPDIR", "/no/such/folder", 1);
  CHECK(code_of([] { InputFile file("/dev/null"); }) == "file-unwritable");
  CHECK(code_of([] { OutputFile file("-"); }) == "file-unwritable");
  if (before == nullptr) {
    unsetenv("TMPDIR");
  } else {
    setenv("TMPDIR", kept.c_str(), 1);
  }
  CHECK(open_files() == open_before);
}

TEST_CASE("a pipe is written to and stays a pipe") {
  const fs::path path = fs::temp_directory_path() / ("plumbline-pipe-" + std::to_string(getpid()));
  REQUIRE(mkfifo(path.c_str(), 0600) == 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  write_text(path.string(), "hello");
  char text[8] = {};
  CHECK(read(reader, text, sizeof text) == 5);
  CHECK(std::string(text) == "hello");
  CHECK(fs::is_fifo(path));
  close(reader);
  fs::remove(path);
}

TEST_CASE("a pipe is read as a file, at any offset") {
  int ends[2] = {};
  REQUIRE(pipe(ends) == 0);
  REQUIRE(write(ends[1], "hello world", 11) == 11);
  close(ends[1]);
  const InputFile file("/dev/fd/" + std::to_string(ends[0]));
  close(ends[0]);
  CHECK(file.size() == 11);
  char text[5] = {};
  CHECK(file.read(6, text, sizeof text) == 5);
  CHECK(std::string(text, 5) == "world");
}
