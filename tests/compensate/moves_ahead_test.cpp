#include "compensate/moves_ahead.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"

using namespace plumbline;
using compensate::Corrected;
using compensate::CorrectedMove;
using compensate::MoveCorrector;
using compensate::MovesAhead;
using compensate::PointsAhead;

namespace {

struct Looked {
  explicit Looked(const std::string& text, const Job& job = standing_at_zero())
      : opened(text, job),
        ahead(opened.job.model, opened.job.settings, opened.dialect, opened.job.program.tools,
              opened.reader_settings()) {
    nc::Program program(opened.source, opened.dialect, opened.job.program);
    while (const nc::Step* const step = program.next()) REQUIRE(steps.add(*step, program, files));
    ahead.look(steps, 0);
    ahead.come_to(steps[0].step, 1, 0);
  }
  const PointsAhead& points() const { return ahead.points(); }

  Opened opened;
  MovesAhead ahead;
  nc::FileNames files;
  nc::KeptSteps steps;
};

nc::Tool tool(int number, double mass_kg) {
  nc::Tool tool;
  tool.number = number;
  tool.mass_kg = mass_kg;
  return tool;
}

}  // namespace

TEST_CASE("the points of short moves are corrected ahead, as each is alone, to the bit") {
  const Looked looked("G21 G90 G94\nG0 X1\nG1 X2 F100\nX5 A0.1\nX200\nG4 P1\nX201\nM2\n");
  const std::vector<compensate::Target>& targets = looked.points().targets;
  REQUIRE(targets.size() == 1 + 3 + 1);  // the rapid and the long move are left out
  CHECK(looked.points().tools == 1);
  CHECK(targets.front().pose[Axis::X] == 2);
  CHECK(targets.back().pose[Axis::X] == 201);
  compensate::Corrector corrector(looked.opened.job.model, looked.opened.job.settings);
  corrector.set_tool({0, looked.opened.job.model.reference_tool_mass, 0});
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Corrected alone = corrector.correct(targets[i]);
    REQUIRE(alone.converged);
    CHECK(looked.points().corrections[i].pose == alone.pose);
    CHECK(looked.points().corrections[i].sign == alone.sign);
  }
}

TEST_CASE("a move that would be cut into too many pieces is left to who comes to it") {
  Job job = standing_at_zero();
  job.settings.step.length_mm = 1e-9;
  const Looked looked("G21 G90 G94\nG1 X2 F100\nM2\n", job);
  CHECK(looked.points().targets.empty());
}

TEST_CASE("axes that are taken to stand at zero get no correction") {
  Looked looked("G21 G90 G94\nG1 X1 F100\nM2\n");
  REQUIRE(looked.points().targets.size() == 1);
  CHECK(looked.points().targets.front().fixed.empty());
  looked.ahead.come_to(looked.steps[1].step, 1, 0);
  CHECK(looked.ahead.move_of(looked.steps[1].step, AxisSet::rotary()) == nullptr);  // from now on they are
  looked.ahead.look(looked.steps, 1);
  looked.ahead.come_to(looked.steps[0].step, 2, 1);
  REQUIRE(looked.points().targets.size() == 1);
  CHECK(looked.points().targets.front().fixed == AxisSet::rotary());
}

TEST_CASE("who comes to a step gets its move, divided, and where its points are; a step made of it gets none") {
  Looked looked("G21 G90 G94\nG1 X2 F100\nG0 X3\nG1 X6\nG1 X400\nG1 X401\nM2\n");
  struct Wanted {
    std::size_t step;
    int pieces;
    std::size_t first;
  };
  std::vector<Wanted> found;
  for (std::size_t i = 0; i < looked.steps.size(); ++i) {
    const nc::Step& step = looked.steps[i].step;
    looked.ahead.come_to(step, 1, 0);
    const compensate::MoveAhead* const ahead = looked.ahead.move_of(step, {});
    if (ahead == nullptr) continue;
    found.push_back({i, ahead->move.pieces, ahead->first});
    CHECK(ahead->move.step == &step);
    const nc::Step other = step;
    CHECK(looked.ahead.move_of(other, {}) == nullptr);
  }
  REQUIRE(found.size() == 3);  // the rapid and the long move are left out
  CHECK((found[0].step == 1 && found[0].pieces == 2 && found[0].first == 0));
  CHECK((found[1].step == 3 && found[1].pieces == 3 && found[1].first == 2));
  CHECK((found[2].step == 5 && found[2].pieces == 1 && found[2].first == 5));
}

TEST_CASE("points are corrected with the tool that makes them, those behind a further change are left out") {
  Job job = standing_at_zero();
  job.program.keeps_position = {6};
  job.program.tools = nc::ToolTable({tool(1, 1), tool(2, 9)});
  const Looked looked("G21 G90 G94\nT1 M6\nG1 X1 F100\nT2 M6\nG1 X2\nM2\n", job);
  REQUIRE(looked.points().targets.size() == 1);
  CHECK(looked.points().tools == 2);  // what is in the spindle at the start, and the first
  compensate::Corrector corrector(looked.opened.job.model, looked.opened.job.settings);
  corrector.set_tool({0, 1, 0});
  CHECK(looked.points().corrections[0].pose == corrector.correct(looked.points().targets[0]).pose);
}
