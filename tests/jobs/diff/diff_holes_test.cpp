// Holes of cycles, whose way may have rapids in one program that the other has not.
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "jobs/diff/compensated.hpp"

using namespace plumbline;
using jobs::DiffSummary;
using testing::compensated;
using testing::diff_of;
using testing::is_whole;

TEST_CASE("a cycle that begins where the tool stands is aligned, though a correction makes a tiny way there") {
  for (const double clear : {2.0, 4.5, 5.0}) {
    INFO("from Z" << clear);
    const std::string program = fmt::format(
        "G21 G90 G94 G17\nG0 X40 Y-30 Z{0} A4 B-3 C0\nM3 S500\nG98 G84 X40 Y-30 Z-10 R0.01 F500\n"
        "X60 Y-30\nG80\nG1 X0 F900\nG0 Z{0}\nM2\n",
        clear);
    const testing::Scratch scratch;
    const std::string output = compensated(scratch, program);
    INFO(output);
    const DiffSummary s = diff_of(program, output);
    CHECK(is_whole(s));
    for (const Axis axis : kAllAxes) CHECK(s.shift[index(axis)].largest < 0.05);
  }
}

TEST_CASE("tiny rapids of one side alone belong to those beside them") {
  const std::string a = "G0 X0 Y0 Z5\nG0 Z3.5\nG1 Z-2 F100\nG0 Z5\n";
  const std::string b = "G0 X0 Y0 Z5\nG0 X0.0004\nG0 Z3.5\nG1 Z-2 F100\nG0 Z5\n";
  for (const DiffSummary& s : {diff_of(a, b), diff_of(b, a)}) {
    CHECK(is_whole(s));
    CHECK(s.shift[0].largest == Approx(0.0004));
    CHECK(s.shift[2].largest == 0);
  }
}

TEST_CASE("tiny rapids after a long one belong to it, whatever comes next") {
  for (const char* const next : {"G1 Z-2 F100\nG0 Z5\n", "G0 X9 Y9\nG1 Z1 F100\n", "G4 P1\nG1 X3 F9\n"}) {
    const std::string a = "G0 X0 Y0 Z5\nG0 X20\n" + std::string(next);
    const std::string b = "G0 X0 Y0 Z5\nG0 X20\nG0 Z4.9975\n" + std::string(next);
    for (const DiffSummary& s : {diff_of(a, b), diff_of(b, a)}) {
      INFO(next);
      CHECK(s.out_of_line_a == 0);
      CHECK(s.out_of_line_b == 0);
      CHECK(s.shift[2].largest <= Approx(0.0025));
    }
  }
}

TEST_CASE("the way to a level R that the corrections of far holes are apart belongs to the rapid before it") {
  const std::string a = "G0 X0 Y0 Z5\nG0 Z1\nG1 Z-2 F100\nG0 Z1\nG0 X500\nG1 Z-2 F100\nG0 Z1\n";
  const std::string b =
      "G0 X0.1 Y0 Z5\nG0 Z1.05\nG1 Z-1.95 F100\nG0 Z1.05\nG0 X500\nG0 Z0.75\nG1 Z-2.25 F100\nG0 Z0.75\n";
  const DiffSummary s = diff_of(a, b);
  CHECK(s.out_of_line_a == 0);
  CHECK(s.out_of_line_b == 0);
  CHECK(s.shift[2].largest == Approx(0.25));
}

TEST_CASE("a tiny rapid before a cut belongs to it where the first program stands there already") {
  const std::string before = "G0 X0 Y0 Z5\nM3 S500\n";
  const std::string after = "G0 Z9\n";
  for (const auto& [hole, tiny] : {std::pair("G1 Z-2 F100\nG1 Z5\n", "G0 B0.00045\n"),
                                   std::pair("G1 X3 Z-2 F100\nG1 Z5\n", "G0 A0.0004\nG0 B0.0003\n"),
                                   std::pair("G1 X0 Y4 F80\nG2 X6 Y4 I3\n", "G0 C0.001\n")}) {
    const std::string a = before + hole + hole + after;
    const std::string b = before + hole + tiny + hole + after;
    INFO(b);
    const DiffSummary s = diff_of(a, b);
    CHECK(is_whole(s));
    CHECK(s.time_change.value < 1e-3);
  }
  const DiffSummary far = diff_of(before + "G1 X3 F100\n", before + "G0 Y0.5\nG1 X3 F100\n");
  CHECK(far.out_of_line_b > 0);
}

TEST_CASE("the way to a hole that the correction divides is in line, over the hole and down to its R") {
  for (const char* const holes :
       {"G99 G84 X11.5 Y-21.5 Z3.9 R6.8 F2173.5\nX-35.2\n", "G86 X-1.5 Y-0.1 Z2.6 R4.9 P0.1 F90\nY-8.4\nX5\n",
        "G98 G74 X4 Y6 Z-9 R7.5 F400\nG99 X-7 Y9\nX12\n", "G91 G99 G84 X3 Y4 Z-7 R-1 F300\nX9 R0\nG90\n"}) {
    const std::string turns = std::string(holes).find("G74") == std::string::npos ? "M3" : "M4";
    const std::string program =
        "G21 G90 G94 G17\nG0 X-39 Y8 Z9.6 A-2.4 B4.9 C-5.7\n" + turns + " S500\n" + holes + "G80\nG0 Z20\nM2\n";
    INFO(program);
    const testing::Scratch scratch;
    const std::string output = compensated(scratch, program);
    INFO(output);
    for (const DiffSummary& s : {diff_of(program, output), diff_of(output, program)}) {
      CHECK(is_whole(s));
      for (const Axis axis : kAllAxes) CHECK(s.shift[index(axis)].largest < 0.05);
    }
  }
}

TEST_CASE("the way that the corrections of two holes are apart belongs to the second, however large they are") {
  const std::string start = "G21 G90 G94 G17\nG0 X-36 Y87 Z105 A-11 B-16.6 C-14.3\nG1 B10.977 F1772\nM3 S500\n";
  for (const char* const holes :
       {"G99 G84 X173.57 Y219.951 Z98.8 R100.176 F182.1\nY-77.397\nX57.534\n",
        "G99 G86 X170 Y215 Z98 R101 P0.1 F182.1\nY-80\nX60\n", "G99 G84 X165 Y-80 Z97 R99 F182.1\nX-10 Y210\nX160\n"}) {
    const std::string program = start + holes + "G80\nM2\n";
    INFO(program);
    const testing::Scratch scratch;
    const DiffSummary s = diff_of(program, compensated(scratch, program, 2.2, 4.1));
    CHECK(s.shift[index(Axis::Z)].largest > 0.2);
    CHECK(is_whole(s));
  }
}
