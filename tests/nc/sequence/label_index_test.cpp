#include "nc/sequence/label_index.hpp"

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;

namespace {

std::size_t line_of(const LinePlace* place) { return place == nullptr ? 0 : place->line; }

}  // namespace

TEST_CASE("labels are those of the program around the line, forward first") {
  const testing::Scratch scratch;
  const InputFile program(scratch.file("main.nc", "O1\nN10 G0\nN20 G0\nN10 G0\nM30\nO2\nN20 G0\nN010 G0\nM99\n"));
  ProgramFiles files(program, dialect("fanuc"));
  LabelIndex index(files, dialect("fanuc"));
  CHECK(line_of(index.find_label("N10", 3, Direction::both)) == 4);
  CHECK(line_of(index.find_label("N10", 5, Direction::both)) == 2);
  CHECK(line_of(index.find_label("N10", 6, Direction::both)) == 8);
  CHECK(line_of(index.find_label("N20", 3, Direction::forward)) == 0);
  CHECK(line_of(index.find_label("N10", 4, Direction::backward)) == 4);
  CHECK(line_of(index.find_label("N30", 1, Direction::both)) == 0);
}

TEST_CASE("a program is looked for in the file, then in one of its name") {
  const testing::Scratch scratch;
  scratch.file("O0007.NC", "G0\nM99\n");
  scratch.file("O0008.NC", "O9\nM99\n");
  const InputFile program(scratch.file("main.nc", "O1\nM30\nO0002\nM99\n"));
  ProgramFiles files(program, dialect("fanuc"));
  LabelIndex index(files, dialect("fanuc"));
  const auto inside = index.find_program("2");
  REQUIRE(inside.has_value());
  CHECK(inside->file == 0);
  CHECK(inside->line.line == 3);
  const auto beside = index.find_program("7");  // the file names none, so that it holds the one of its name
  REQUIRE(beside.has_value());
  CHECK(beside->file == 1);
  CHECK(index.find_program("7")->file == 1);
  CHECK_FALSE(index.find_program("8").has_value());
  CHECK(index.find_program("9")->file == 2);
}

TEST_CASE("after the second % of a tape stands nothing that the control knows") {
  const testing::Scratch scratch;
  const InputFile program(scratch.file("main.nc", "%\nO1\nM30\n%\nN10 G0\n"));
  ProgramFiles files(program, dialect("fanuc"));
  LabelIndex index(files, dialect("fanuc"));
  CHECK(index.find_label("N10", 2, Direction::both) == nullptr);
}

TEST_CASE("loops by number lie one inside the other; a comment is none") {
  const testing::Scratch scratch;
  const InputFile program(
      scratch.file("main.nc",
                   "O1\nDO 1\nN5 WHILE [#1 LT 2] DO 2 (DO 1])\nEND 2\nEND 1\nDO 1\nEND1\nDO 3\nDO 1\nEND 3\nEND 1\n"
                   "DO 2\n/ DO 2\nEND 2\nEND 2\nM30\n"));
  ProgramFiles files(program, dialect("fanuc"));
  LabelIndex index(files, dialect("fanuc"));
  for (const std::size_t line : {2, 3, 6}) CHECK_FALSE(index.crossing(line).has_value());
  CHECK(index.crossing(8) == 10);
  CHECK(index.crossing(12) == 13);
}
