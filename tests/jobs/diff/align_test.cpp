// Whole programs, compensated and drawn at random, are in diff_test.cpp and diff_drawn_test.cpp.
#include "jobs/diff/align.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "jobs/diff/read_moves.hpp"
#include "nc/rewrite/output/emit_settings.hpp"

using namespace plumbline;

namespace {

jobs::DiffSummary aligned(std::string_view a, std::string_view b) {
  testing::ReadMoves first(a);
  testing::ReadMoves second(b);
  jobs::Aligner aligner(first.queue(), second.queue(), nc::EmitSettings{}.time_tolerance);
  while (aligner.next()) {
  }
  return aligner.take();
}

constexpr std::string_view kTwoCuts = "G0 Z5\nG1 X10 F600\nG1 X20\n";

}  // namespace

TEST_CASE("pieces are one move, and each end is a point") {
  const jobs::DiffSummary s = aligned(kTwoCuts, "G0 Z5.02\nG1 X5 F600\nX10\nG1 X15\nX20\n");
  CHECK(s.matched == 3);
  CHECK(s.points == 1 + 2 + 2);
  CHECK(s.out_of_line.empty());
  CHECK(s.shift[index(Axis::Z)].largest == Approx(0.02));
  CHECK(s.shift[index(Axis::Z)].rms == Approx(0.02));
  CHECK(s.shift[index(Axis::X)].largest == Approx(0).margin(1e-9));
  CHECK(s.seconds_a == Approx(2));  // 20 mm at 10 mm/s
  CHECK(s.seconds_b == Approx(2));
}

TEST_CASE("the largest shift has the lines of both programs, and rms counts all points") {
  const jobs::DiffSummary s = aligned(kTwoCuts, "G0 Z5\n\nG1 X10 F600\n\nG1 X20 Y0.06\n");
  const jobs::AxisShift& y = s.shift[index(Axis::Y)];
  CHECK(y.largest == Approx(0.06));
  CHECK(y.line_a == 3);
  CHECK(y.line_b == 5);
  CHECK(y.rms == Approx(0.06 / std::sqrt(3.0)));  // of three points
}

TEST_CASE("a feed that differs is a change of time, not a move out of line") {
  const jobs::DiffSummary s = aligned(kTwoCuts, "G0 Z5\nG1 X10 F540\nG1 X20 F600\n");
  CHECK(s.matched == 3);
  CHECK(s.time_change.value == Approx(1 / 0.9 - 1));
  CHECK(s.time_change.line == 2);
  CHECK(s.seconds_b == Approx(1 / 0.9 + 1));
}

TEST_CASE("a way that B leaves out is out of line up to where both end in one place") {
  const jobs::DiffSummary s =
      aligned("G0 Z5\nG1 X10 F600\nG1 Y30\nG1 Y0\nG1 X20\nG1 X30\n", "G0 Z5\nG1 X10 F600\nG1 X20\nG1 X30\n");
  CHECK(s.matched == 3);
  CHECK(s.out_of_line_a == 3);
  CHECK(s.out_of_line_b == 1);
  REQUIRE(s.out_of_line.size() == 1);
  CHECK(s.out_of_line[0].first_line_a == 3);
  CHECK(s.out_of_line[0].last_line_a == 5);
  CHECK(s.out_of_line[0].first_line_b == 3);
  CHECK(s.out_of_line[0].last_line_b == 3);
  CHECK(s.seconds_a == Approx(1 + 3 + 3 + 1 + 1));
  CHECK(s.seconds_b == Approx(3));
}

TEST_CASE("what one program has after the end of the other is out of line, a place each") {
  const jobs::DiffSummary longer_b = aligned("G0 Z5\nG1 X10 F600\n", "G0 Z5\nG1 X10 F600\nG1 X20\nG0 Z50\n");
  CHECK(longer_b.matched == 2);
  CHECK(longer_b.out_of_line_a == 0);
  CHECK(longer_b.out_of_line_b == 2);
  REQUIRE(longer_b.out_of_line.size() == 2);
  CHECK(longer_b.out_of_line[1].first_line_a == 0);
  CHECK(longer_b.out_of_line[1].first_line_b == 4);
  const jobs::DiffSummary longer_a = aligned("G0 Z5\nG1 X10 F600\nG1 X20\nG0 Z50\n", "G0 Z5\nG1 X10 F600\n");
  CHECK(longer_a.out_of_line_a == 2);
  CHECK(longer_a.out_of_line_b == 0);
}
