#include "nc/syntax/line_source.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::ProgramFile;

namespace {

struct Read {
  std::string text, line_end;
  std::size_t line;
  std::uint64_t offset;
  bool whole;
};

std::vector<Read> read_all(const std::string& text, std::size_t window, char goes_on = '\0') {
  const ProgramFile program(text);
  const InputFile file(program.path());
  LineSource lines(file, goes_on, window);
  std::vector<Read> all;
  Line line;
  while (lines.next(line)) {
    // NOLINTBEGIN(readability-simplify-subscript-expr): after the end, where [] may not look
    CHECK((line.text.data()[line.text.size()] == '\0' || line.text.data()[line.text.size()] == '\n' ||
           line.text.data()[line.text.size()] == '\r' || !line.whole));
    // NOLINTEND(readability-simplify-subscript-expr)
    all.push_back({std::string(line.text), std::string(line.line_end), line.place.line, line.place.offset, line.whole});
  }
  return all;
}

}  // namespace

TEST_CASE("lines come whole whatever the window, and put together they are the file") {
  const std::string text = "G0 X1\r\n\nG1 X2 F100\n\r\n  \nlast";
  for (const std::size_t window : {12U, 13U, 16U, 64U, 100000U}) {
    INFO(window);
    const std::vector<Read> lines = read_all(text, window);
    REQUIRE(lines.size() == 6);
    CHECK(lines[0].text == "G0 X1");
    CHECK(lines[0].line_end == "\r\n");
    CHECK(lines[1].text.empty());
    CHECK(lines[2].text == "G1 X2 F100");
    CHECK(lines[2].line == 3);
    CHECK(lines[2].offset == 8);
    CHECK(lines[3].line_end == "\r\n");
    CHECK(lines[5].text == "last");
    CHECK(lines[5].line_end.empty());
    std::string together;
    for (const Read& line : lines) together += line.text + line.line_end;
    CHECK(together == text);
  }
}

TEST_CASE("a line longer than the window comes in pieces that say so") {
  const std::string text = "short\n" + std::string(100, 'x') + "\nend\n";
  const std::vector<Read> lines = read_all(text, 32);
  std::string together;
  for (const Read& line : lines) {
    together += line.text + line.line_end;
    CHECK(line.whole == (line.text == "short" || line.text == "end"));
  }
  CHECK(together == text);
  CHECK(lines.front().whole);
  CHECK(lines.back().text == "end");
  CHECK(lines.back().line == 3);
}

TEST_CASE("reading goes on at any line seen before") {
  const ProgramFile program("one\ntwo\nthree\n");
  const InputFile file(program.path());
  LineSource lines(file);
  Line line;
  lines.next(line);
  lines.next(line);
  const LinePlace second = line.place;
  while (lines.next(line)) continue;
  lines.seek(second);
  REQUIRE(lines.next(line));
  CHECK(line.text == "two");
  CHECK(line.place.line == 2);
  CHECK(line.place.offset == 4);
  REQUIRE(lines.next(line));
  CHECK(line.text == "three");
}

TEST_CASE("lines that begin with a mark come with the one before, whatever the window") {
  const std::string text = "$A.MIN%\n$G0\nG1 X1\r\n$Y2\n$Z3\n\n$B.MIN%\nG0 X4\n$Y5";
  for (const std::size_t window : {44U, 50U, 64U, 100000U}) {
    INFO(window);
    const std::vector<Read> lines = read_all(text, window, '$');
    REQUIRE(lines.size() == 6);
    CHECK(lines[1].text == "$G0");  // a head has nothing to go on
    CHECK(lines[2].text == "G1 X1\r\n$Y2\n$Z3");
    CHECK(lines[2].line == 3);
    CHECK(lines[3].text.empty());
    CHECK(lines[3].line == 6);
    CHECK(lines[4].text == "$B.MIN%");
    CHECK(lines[5].text == "G0 X4\n$Y5");
    CHECK(lines[5].line == 8);
    std::string together;
    for (const Read& line : lines) together += line.text + line.line_end;
    CHECK(together == text);
  }
  CHECK(read_all(text, 64).size() == 9);
  CHECK(longest_line("ab\n$cde\nf") == 4);
}

TEST_CASE("an empty file has no lines") { CHECK(read_all("", 16).empty()); }

TEST_CASE("a line of which there is no end is refused, in memory that stays bounded") {
  const testing::Scratch scratch;
  const std::string path = scratch.file("p.nc", "G0 X1\n");
  std::filesystem::resize_file(path, kLongestLine * 3);  // NULs that take no room
  const InputFile file(path);
  LineSource lines(file);
  Line line;
  CHECK(lines.next(line));
  CHECK(line.text == "G0 X1");
  CHECK(testing::refusal_of([&] {
          while (lines.next(line)) CHECK_FALSE(line.whole);
        }).code == "file-endless-line");
  lines.seek({0, 1});  // as often as it is read
  CHECK(testing::refusal_of([&] {
          while (lines.next(line)) continue;
        }).code == "file-endless-line");
}
