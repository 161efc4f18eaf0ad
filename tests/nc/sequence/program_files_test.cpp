// Also subprogram_file.cpp, which finds the files.
#include "nc/sequence/program_files.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "nc/language/dialect.hpp"
#include "nc/sequence/subprogram_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;

TEST_CASE("reading goes on in a file beside the program, and comes back to the line after the call") {
  const testing::Scratch scratch;
  scratch.file("side.ngc", "A1\nA2\n");
  const InputFile program(scratch.file("main.ngc", "X1\nX2\nX3\n"));
  ProgramFiles files(program, dialect("linuxcnc"));
  Line line;
  REQUIRE(files.next(line));
  const FilePlace back = files.here();
  CHECK(back.line.line == 2);
  CHECK_FALSE(files.open_beside("nowhere").has_value());
  const auto side = files.open_beside("side");
  REQUIRE(side.has_value());
  CHECK(files.in_program());
  files.go_to({*side, {}});
  CHECK_FALSE(files.in_program());
  REQUIRE(files.next(line));
  CHECK(line.text == "A1");
  files.seek({});
  REQUIRE(files.next(line));
  CHECK(line.text == "A1");
  REQUIRE(files.next(line));
  CHECK_FALSE(files.next(line));
  files.go_to(back);
  CHECK(files.name() == program.name());
  REQUIRE(files.next(line));
  CHECK(line.text == "X2");
}

TEST_CASE("a file that changes while it is read is refused") {
  const testing::Scratch scratch;
  scratch.file("side.ngc", "A1\n");
  const InputFile program(scratch.file("main.ngc", "X1\n"));
  ProgramFiles files(program, dialect("linuxcnc"));
  REQUIRE(files.open_beside("side").has_value());
  files.check_unchanged();
  scratch.file("side.ngc", "A1\nA2\n");
  CHECK_THROWS_AS(files.check_unchanged(), Refusal);
}

TEST_CASE("a number that several files may be is refused where these differ") {
  const testing::Scratch scratch;
  const std::string program = scratch.path("part.nc");
  const auto found = [&](const char* name, const char* dialect) {
    return subprogram_file(program, name, nc::dialect(dialect)).filename().string();
  };
  scratch.file("O2000.nc", "O2000\nM99\n");
  CHECK(found("2000", "fanuc") == "O2000.nc");
  scratch.file("O2000", "O2000\nM99\n");
  CHECK_FALSE(found("2000", "fanuc").empty());  // the same program twice
  scratch.file("O2000", "O2000\nG1 X5.\nM99\n");
  const Diagnostic refused = testing::refusal_of([&] { found("2000", "fanuc"); });
  CHECK(refused.code == "nc-subprogram-ambiguous");
  CHECK(refused.place.file == program);
  CHECK(refused.message.find("O2000.nc") != std::string::npos);
  CHECK(found("1", "fanuc").empty());

  // A SINUMERIK has an order for names.
  scratch.file("PART.SPF", "M17\n");
  scratch.file("PART.MPF", "G1 X5\nM17\n");
  CHECK_FALSE(found("PART", "siemens").empty());
}
