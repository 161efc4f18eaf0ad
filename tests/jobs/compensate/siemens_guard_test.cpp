// That these lines are told from a program's own is in guard_block_test.cpp, and so is what is refused before them.
#include <algorithm>

#include <catch2/catch.hpp>

#include "jobs/compensate/guards.hpp"

using namespace plumbline;

namespace {

std::vector<std::string> siemens_lines(const nc::ProgramSettings& program, AxisSet assumed = {}) {
  return jobs::siemens_guard(program, assumed, nc::dialect("siemens"));
}

}  // namespace

TEST_CASE("Siemens: without offsets nothing is compared, and no frame is left in force") {
  CHECK(siemens_lines({}) == std::vector<std::string>{"G500"});
}

TEST_CASE("Siemens: a system is chosen, then six shifts and three turns are compared") {
  nc::ProgramSettings program;
  program.work_offsets[0] = nc::WorkOffset{{{0, 1.5, -1008.00004, 0, 0, -5}}, 0};
  const std::vector<std::string> lines = siemens_lines(program);
  REQUIRE(lines.size() == 1 + 9 * 5 + 1);  // each comparison: IF, MSG, M0, M30, ENDIF
  CHECK(lines[0] == "G54");
  CHECK(lines[6] == "IF ABS($P_ACTFRAME[Y,TR]-(1.5))>0.001");
  CHECK(lines[7] == "MSG(\"plumbline guard: this program was made for G54 Y1.5\")");
  CHECK(lines[8] == "M0");
  CHECK(lines[9] == "M30");
  CHECK(lines[10] == "ENDIF");
  CHECK(lines[11] == "IF ABS($P_ACTFRAME[Z,TR]-(-1008))>0.001");
  CHECK(lines[26] == "IF ABS($P_ACTFRAME[C,TR]-(-5))>0.001");
  CHECK(lines[31] == "IF ABS($P_ACTFRAME[X,RT]-(0))>0.001");
  CHECK(lines[32] == "MSG(\"plumbline guard: this program was made for G54 without a turn\")");
  CHECK(lines.back() == "G500");
}

TEST_CASE("Siemens: an axis that no word names must stand where it was taken to stand, once all systems are compared") {
  nc::ProgramSettings program;
  program.work_offsets[1] = nc::WorkOffset{};  // G55
  program.start[index(Axis::B)] = -2.5;
  const std::vector<std::string> lines = siemens_lines(program, {Axis::B, Axis::C});
  CHECK(lines.front() == "G55");
  REQUIRE(lines.size() == 1 + 9 * 5 + 2 * 5 + 1);
  CHECK(lines[46] == "IF ABS($AA_IW[B]-(-2.5))>0.001");
  CHECK(lines[47] == "MSG(\"plumbline guard: this program was made for B at -2.5 deg\")");
  CHECK(lines[51] == "IF ABS($AA_IW[C]-(0))>0.001");
  CHECK(std::count(lines.begin(), lines.end(), "ENDIF") == 11);
}
