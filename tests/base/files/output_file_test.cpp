// How files appear, and what they replace, is in files_test.cpp and output_set_test.cpp.
#include "base/files/output_file.hpp"

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("size and hash are those of all that was written, flushed or not") {
  const testing::Scratch scratch;
  OutputFile file(scratch / "out");
  CHECK(file.hash() == 0);  // nobody asked for it
  file.keep_hash();
  CHECK(file.hash() == fnv1a(""));
  file.write("foo");
  file.flush();
  file.write("bar");
  CHECK(file.size() == 6);
  CHECK(file.hash() == fnv1a("foobar"));
  file.commit();
  CHECK(scratch.text("out") == "foobar");
}

TEST_CASE("what was flushed is read back before the file appears") {
  const testing::Scratch scratch;
  OutputFile file(scratch / "out");
  file.write("0123456789");
  char four[4] = {};
  CHECK(file.read(0, four, 4) == 0);  // still in its buffer
  file.flush();
  CHECK(file.read(4, four, 4) == 4);
  CHECK(std::string(four, 4) == "4567");
  CHECK(file.read(8, four, 4) == 2);
  CHECK_FALSE(scratch.has("out"));
}

TEST_CASE("a file that starts again forgets what was flushed, too") {
  const testing::Scratch scratch;
  OutputFile file(scratch / "out");
  file.keep_hash();
  file.write("wrong, and longer");
  file.flush();
  file.write("more");
  file.restart();
  CHECK(file.size() == 0);
  CHECK(file.hash() == fnv1a(""));
  file.write("right");
  file.commit();
  CHECK(scratch.text("out") == "right");
}

TEST_CASE("a copy gets all that was written so far, after what it holds") {
  const testing::Scratch scratch;
  OutputFile from(scratch / "from");
  OutputFile to(scratch / "to");
  const std::string large(600'000, 'x');  // more than a buffer holds
  to.write("head ");
  from.write(large);
  from.copy_to(to);
  from.write("later");
  to.commit();
  from.commit();
  CHECK(scratch.text("to") == "head " + large);
  CHECK(scratch.text("from") == large + "later");
}

TEST_CASE("what cannot be written is refused by the name that the user gave") {
  const testing::Scratch scratch;
  const Diagnostic refused = testing::refusal_of([&] { OutputFile file(scratch / "none/out.ngc"); });
  CHECK(refused.code == "file-unwritable");
  CHECK(refused.place.file == scratch / "none/out.ngc");
  CHECK(refused.help == "check that " + (scratch / "none") + " exists, may be written to and has room");
  OutputFile full("/dev/full");
  full.write("text");
  const Diagnostic no_room = testing::refusal_of([&] { full.commit(); });
  CHECK(no_room.code == "file-unwritable");
  CHECK(no_room.help == "check that /dev/full exists, may be written to and has room");
}
