#include "jobs/program/survey_program.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

jobs::OpenedProgram opened(const testing::Scratch& scratch, std::string_view text, const nc::ToolTable& tools = {}) {
  jobs::OpenedProgram program = jobs::open_program({}, scratch.file("p.ngc", text));
  program.settings.tools = tools;
  return program;
}

}  // namespace

TEST_CASE("a survey holds the axes that a program names, in its text and not in its comments") {
  const testing::Scratch scratch;
  const jobs::OpenedProgram program = opened(scratch, "G21\nG0 X1 Z2 (A5 is not one)\nG1 b3 F100 ; C4\nM2\n");
  const compensate::ProgramSurvey survey = jobs::survey_program(program);
  CHECK(survey.named == AxisSet{Axis::X, Axis::Z, Axis::B});
  CHECK(survey.unnamed() == AxisSet{Axis::A, Axis::C});
  CHECK(survey.dialect.name == "linuxcnc");
}

TEST_CASE("a survey holds the tools that a program may use, the one in the spindle too") {
  const testing::Scratch scratch;
  const nc::ToolTable table({{1, 10, {}, {}, {}}, {2, 20, {}, {}, {}}, {3, 30, {}, {}, {}}});
  jobs::OpenedProgram program = opened(scratch, "T2 M6\nG0 X1\nM2\n", table);
  REQUIRE(jobs::survey_program(program).tools.size() == 1);
  CHECK(jobs::survey_program(program).tools[0].number == 2);
  program.settings.tool_in_spindle = 3;
  CHECK(jobs::survey_program(program).tools.size() == 2);
  program.settings.tools = {};
  CHECK(jobs::survey_program(program).tools.empty());
}
