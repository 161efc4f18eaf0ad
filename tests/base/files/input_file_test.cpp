// Pipes, links and files that change while they are read are in files_test.cpp and output_set_test.cpp.
#include "base/files/input_file.hpp"

#include <catch2/catch.hpp>

#include "base/files/input_name.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("bytes are read as they stand, nulls and line ends too") {
  const testing::Scratch scratch;
  const std::string bytes("a\0\r\n\xFF", 5);
  const InputFile file(scratch.file("in", bytes));
  CHECK(file.size() == 5);
  char all[8] = {};
  CHECK(file.read(0, all, sizeof all) == 5);
  CHECK(std::string(all, 5) == bytes);
  CHECK(read_text(scratch / "in") == bytes);
  CHECK(read_text(scratch.file("empty", "")).empty());
}

TEST_CASE("what cannot be opened is refused with the name as it was written") {
  const testing::Scratch scratch;
  const std::string below = scratch.file("file", "") + "/below";
  const Diagnostic unreadable = testing::refusal_of([&] { InputFile file(below); });
  CHECK(unreadable.code == "file-unreadable");
  CHECK(unreadable.place.file == below);
  CHECK(unreadable.message == "cannot be opened: Not a directory");
  const Diagnostic missing = testing::refusal_of([&] { read_text(scratch / "none"); });
  CHECK(missing.code == "file-missing");
  CHECK(missing.help == "check the path and its permissions");
}

TEST_CASE("a device is read to its end, kept, and never said to have changed") {
  const InputFile none("/dev/null");
  CHECK(none.size() == 0);
  CHECK(none.name() == "/dev/null");
  CHECK_NOTHROW(none.check_unchanged());
}

TEST_CASE("a device without line ends is refused") {
  const Diagnostic endless = testing::refusal_of([] { InputFile file("/dev/zero"); });
  CHECK(endless.code == "file-endless-line");
  CHECK(endless.place.file == "/dev/zero");
  CHECK(endless.message.find("100 million") != std::string::npos);
  CHECK(testing::refusal_of([] { read_text(Source("/dev/zero")); }).code == "file-endless-line");
}

TEST_CASE("a pipe that gives lines without end is refused, too") {
  PipedText piped("<stdin>", 10'000);
  for (int i = 0; i < 2000; ++i) piped.take("G4P1\n");
  const Diagnostic endless = testing::refusal_of([&] { piped.take("y"); });
  CHECK(endless.code == "file-too-large");
  CHECK(endless.place.file == "<stdin>");
  CHECK(endless.message == "gives more than 1e-05 GB, or has no end");
}

TEST_CASE("a file moves with all that is known of it") {
  const testing::Scratch scratch;
  InputFile first(scratch.file("in", "text"));
  const InputFile second(std::move(first));
  CHECK(second.name() == scratch / "in");
  CHECK(second.is_same_as(scratch / "in"));
  CHECK_NOTHROW(second.check_unchanged());
  scratch.file("in", "other");
  CHECK(testing::refusal_of([&] { second.check_unchanged(); }).code == "file-changed");
  CHECK_FALSE(second.is_same_as(scratch / "in"));
}

TEST_CASE("standard input has a name of its own") {
  CHECK(input_name("-") == "<stdin>");
  CHECK(input_name("part.ngc") == "part.ngc");
  CHECK(input_name("./-") == "./-");
}
