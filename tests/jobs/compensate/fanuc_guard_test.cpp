// What a control makes of these lines, and that they fit it, is in guard_block_test.cpp.
#include <catch2/catch.hpp>

#include "jobs/compensate/guards.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

std::vector<std::string> fanuc_lines(const nc::ProgramSettings& program, AxisSet assumed = {}) {
  return jobs::fanuc_guard(program, assumed, nc::dialect("fanuc"));
}

}  // namespace

TEST_CASE("Fanuc: the start is checked by modal codes, and G92 by where the axes stand") {
  const std::vector<std::string> lines = fanuc_lines({});
  REQUIRE(lines.size() == 6);
  CHECK(lines[0] == "IF [#4006 NE 21] THEN #3000=101(PLUMBLINE: START IN G21)");
  CHECK(lines[1] == "IF [#4014 NE 54] THEN #3000=101(PLUMBLINE: START IN G54)");
  CHECK(lines[2] == "IF [#4008 NE 49] THEN #3000=101(PLUMBLINE: START IN G49)");
  CHECK(lines[3] == "IF [ABS[#5021-#5041-[#5201+#5221]] GT 0.001] THEN #3000=101(PLUMBLINE: G92 SHIFTS X)");
  CHECK(lines[5] == "IF [ABS[#5023-#5043-[#5203+#5223]] GT 0.001] THEN #3000=101(PLUMBLINE: G92 SHIFTS Z)");
}

TEST_CASE("Fanuc: each axis of a system has the variable twenty further on for each system") {
  nc::ProgramSettings program;
  program.work_offsets[5] = nc::WorkOffset{{{1.5, 0, 0, 0, 0, -5}}, 0};   // G59: 5221 + 5 x 20
  program.work_offsets[6] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};  // G54.1 P1
  const std::vector<std::string> lines = fanuc_lines(program);
  REQUIRE(lines.size() == 6 + 2 * 6);
  CHECK(lines[6] == "IF [ABS[#5201+#5321-[1.5]] GT 0.001] THEN #3000=101(PLUMBLINE: G59 X)");
  CHECK(lines[11] == "IF [ABS[#5206+#5326-[-5.0]] GT 0.001] THEN #3000=101(PLUMBLINE: G59 C)");
  CHECK(lines[14] == "IF [ABS[#5203+#7003-[-1008.0]] GT 0.001] THEN #3000=101(PLUMBLINE: G54.1 P1 Z)");
}

TEST_CASE("Fanuc: a number has eight digits at most, the last ones rounded away") {
  nc::ProgramSettings program;
  program.work_offsets[0] = nc::WorkOffset{{{1234.56789, 123456.7891, -0.00004, 0, 0, 0}}, 0};
  const std::vector<std::string> lines = fanuc_lines(program);
  CHECK(lines.at(6).find("-[1234.5679]]") != std::string::npos);
  CHECK(lines.at(7).find("-[123456.79]]") != std::string::npos);
  CHECK(lines.at(8).find("-[0.0]]") != std::string::npos);
}

TEST_CASE("Fanuc: axes that no word names must stand where they were taken to stand") {
  nc::ProgramSettings program;
  program.start[index(Axis::B)] = 2.25;
  const std::vector<std::string> lines = fanuc_lines(program, {Axis::A, Axis::B});
  REQUIRE(lines.size() == 8);
  CHECK(lines[6] == "IF [ABS[#5044-[0.0]] GT 0.001] THEN #3000=101(PLUMBLINE: START AT A0)");
  CHECK(lines[7] == "IF [ABS[#5045-[2.25]] GT 0.001] THEN #3000=101(PLUMBLINE: START AT B2.25)");
}

TEST_CASE("Fanuc: a system whose variables no source tells is refused") {
  nc::ProgramSettings program;
  program.work_offsets[6 + 48] = nc::WorkOffset{};
  const Diagnostic refused = testing::refusal_of([&] { fanuc_lines(program); });
  CHECK(refused.code == "guard-system");
  CHECK(refused.message.find("G54.1 P49") != std::string::npos);
}
