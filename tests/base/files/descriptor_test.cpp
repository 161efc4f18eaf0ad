#include "base/files/descriptor.hpp"

#include <cerrno>
#include <string>
#include <utility>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

bool is_open_file(int number) { return fcntl(number, F_GETFD) != -1; }

int opened(const std::string& path, int flags) { return open(path.c_str(), flags | O_CLOEXEC, 0600); }

}  // namespace

TEST_CASE("an open file is closed once, by the last one that has it") {
  const int number = opened("/dev/null", O_RDONLY);
  {
    Descriptor first(number);
    CHECK(first.is_open());
    const Descriptor second(std::move(first));
    CHECK(second.number() == number);
    CHECK(is_open_file(number));
  }
  CHECK_FALSE(is_open_file(number));
  CHECK_FALSE(Descriptor().is_open());
}

TEST_CASE("what is put in the place of an open file closes it; what is handed over stays open") {
  const int one = opened("/dev/null", O_RDONLY);
  const int two = opened("/dev/null", O_RDONLY);
  Descriptor file(one);
  file = Descriptor(two);
  CHECK_FALSE(is_open_file(one));
  CHECK(file.release() == two);
  CHECK_FALSE(file.is_open());
  CHECK(is_open_file(two));
  CHECK(Descriptor(two).close());
  CHECK_FALSE(is_open_file(two));
}

TEST_CASE("a close that fails is told, and one of nothing does not fail") {
  Descriptor nothing;
  CHECK(nothing.close());
  const int number = opened("/dev/null", O_RDONLY);
  Descriptor gone(number);
  ::close(number);
  CHECK_FALSE(gone.close());
  CHECK_FALSE(gone.is_open());
}

TEST_CASE("a copy goes from where one file stands to its end, beyond the size of its buffer") {
  const testing::Scratch scratch;
  const std::string text(200'000, 'x');
  const Descriptor from(opened(scratch.file("from", "head" + text + "end"), O_RDONLY));
  const Descriptor to(opened(scratch / "to", O_WRONLY | O_CREAT));
  REQUIRE(lseek(from.number(), 4, SEEK_SET) == 4);
  CHECK(copy_all(from.number(), to.number()));
  CHECK(scratch.text("to") == text + "end");
  CHECK(copy_all(from.number(), to.number()));  // there is no more
  CHECK(scratch.text("to").size() == 200'003);
}

TEST_CASE("bytes that the system does not take are told") {
  const Descriptor full(opened("/dev/full", O_WRONLY));
  CHECK_FALSE(write_all(full.number(), "text", 4));
  CHECK(errno == ENOSPC);
  CHECK(write_all(full.number(), "text", 0));
  const Descriptor readable(opened("/dev/zero", O_RDONLY));
  CHECK_FALSE(write_all(readable.number(), "text", 4));
  CHECK_FALSE(copy_all(full.number(), readable.number()));
}

TEST_CASE("where too many files are open that is the way out") {
  CHECK(way_out(EACCES, "look at its permissions") == "look at its permissions");
  CHECK(way_out(EMFILE, "look at its permissions").find("ulimit -n") != std::string::npos);
  CHECK(way_out(ENFILE, "check that it exists").find("check that it exists") == std::string::npos);
}
