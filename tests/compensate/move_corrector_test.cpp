#include "compensate/move_corrector.hpp"

#include <vector>

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"

using namespace plumbline;
using compensate::CorrectedMove;
using compensate::MoveCorrector;

namespace {

struct CorrectedProgram {
  explicit CorrectedProgram(const std::string& text, const Job& job, MoveCorrector::AtViolation at_violation,
                            const AxisWords& standing = {})
      : opened(text, job),
        reader(reader_of(opened)),
        corrector(opened.job.model, opened.job.settings),
        moves(corrector, opened.job.model.limits, at_violation) {
    while (const compensate::Move* const read = reader.next_move()) last = moves.correct(*read, standing);
  }

  Opened opened;
  compensate::MoveReader reader;
  compensate::Corrector corrector;
  MoveCorrector moves;
  CorrectedMove last;
};

}  // namespace

TEST_CASE("pieces that are corrected together get what each gets alone, to the bit") {
  const CorrectedProgram cut("G21 G90 G94\nG1 X300 A5 F1000\nM2\n", standing_at_zero(),
                             MoveCorrector::AtViolation::go_on);
  const CorrectedMove& corrected = cut.last;
  REQUIRE(corrected.points.size() == 300);  // more than go together
  for (std::size_t i = 0; i < corrected.points.size(); ++i) {
    const path::CurvePoint point = corrected.move.path.curve.point(corrected.move.fraction(static_cast<int>(i) + 1));
    const compensate::Target target = corrected.move.path.target(point, corrected.move.seconds);
    const compensate::Corrected alone = cut.corrector.correct(target);
    REQUIRE(alone.converged);
    CHECK(corrected.points[i].shift == corrected.move.path.frame.from_pose(alone.pose) - point.at);
    CHECK(corrected.signs[i] == alone.sign);
  }
}

TEST_CASE("each piece of a cut ends where the correction of its target leads") {
  const CorrectedProgram cut("G21 G90 G94\nG1 X3 A1.5 F100\nM2\n", standing_at_zero(),
                             MoveCorrector::AtViolation::stop);
  const CorrectedMove& corrected = cut.last;
  REQUIRE(corrected.points.size() == 15);  // of 0.1 deg
  CHECK(corrected.signs.size() == 15);
  CHECK(corrected.violations.empty());
  for (std::size_t i = 0; i < corrected.points.size(); ++i) {
    const compensate::Target target =
        corrected.move.path.target(corrected.move.fraction(static_cast<int>(i) + 1), corrected.move.seconds);
    const AxisWords wanted = cut.corrector.correct(target).pose;
    const AxisWords commanded = corrected.commanded(i);
    for (const Axis axis : kAllAxes) CHECK(commanded[axis] == Approx(wanted[axis]).margin(1e-9));
    CHECK(corrected.points[i].share == Approx(1.0 / 15));
  }
}

TEST_CASE("a move takes what was found for its points where they are expected, and only there") {
  const Opened opened("G21 G90 G94\nG1 X3 F100\nG1 X4\nG1 X7\nM2\n", standing_at_zero());
  const compensate::Corrector corrector(opened.job.model, opened.job.settings);
  MoveCorrector moves(corrector, opened.job.model.limits, MoveCorrector::AtViolation::stop);
  compensate::MoveReader reader = reader_of(opened);
  compensate::PointsAhead points;
  points.number = 1;
  std::vector<compensate::Move> read;
  while (const compensate::Move* const move = reader.next_move()) read.push_back(*move);
  REQUIRE(read.size() == 3);
  for (const std::size_t expected : {std::size_t{0}, std::size_t{2}}) {
    for (int i = 1; i <= 3; ++i) {
      points.targets.push_back(read[expected].path.target(read[expected].fraction(i), read[expected].seconds));
    }
  }
  corrector.correct(points.targets, points.corrections);
  MoveCorrector alone(corrector, opened.job.model.limits, MoveCorrector::AtViolation::stop);
  for (const compensate::Move& move : read) {
    moves.expect(&points);
    const CorrectedMove& taken = moves.correct(move, {});
    const CorrectedMove& wanted = alone.correct(move, {});
    REQUIRE(taken.points.size() == wanted.points.size());
    for (std::size_t i = 0; i < taken.points.size(); ++i) {
      CHECK(taken.points[i].shift == wanted.points[i].shift);
      CHECK(taken.points[i].share == wanted.points[i].share);
      CHECK(taken.signs[i] == wanted.signs[i]);
    }
  }
  // What is found for a point is taken, not worked out again.
  compensate::PointsAhead others;
  others.number = 2;
  others.targets = points.targets;
  std::vector<compensate::Target> elsewhere = points.targets;
  for (compensate::Target& target : elsewhere) target.pose[Axis::X] += 20;
  corrector.correct(elsewhere, others.corrections);
  moves.expect(&others);
  CHECK(moves.correct(read.front(), {}).points.front().shift[Axis::X] == Approx(20).margin(0.1));
  const compensate::MoveAhead second{read.front(), 3};  // said to be the one whose points come second
  moves.expect(&others, &second);
  const CorrectedMove& taken = moves.correct(second.move, {});
  REQUIRE(taken.points.size() == 3);
  CHECK(taken.points.front().shift[Axis::X] == Approx(20 + 4).margin(0.1));
  moves.expect(nullptr);
  CHECK(moves.correct(read.front(), {}).points.front().shift[Axis::X] == Approx(0).margin(0.1));
}

TEST_CASE("of a rapid the end alone is corrected") {
  const CorrectedProgram rapid("G21 G90\nG0 X95\nM2\n", standing_at_zero(), MoveCorrector::AtViolation::stop);
  CHECK(rapid.last.move.pieces == 10);
  REQUIRE(rapid.last.points.size() == 1);
  CHECK(rapid.last.points.front().nominal[Axis::X] == 95);
}

TEST_CASE("where a limit is broken the points end, or the worst of each kind is kept") {
  const std::string text = "G21 G90 G94\nG1 X400 F1000\nM2\n";  // 300 is the limit
  const CorrectedProgram stopped(text, standing_at_zero(), MoveCorrector::AtViolation::stop);
  REQUIRE_FALSE(stopped.last.violations.empty());
  CHECK(stopped.last.violations.front().what == "X");
  CHECK(stopped.last.violations.front().by_how_much < 1.5);
  CHECK(stopped.last.points.size() < 302);
  const CorrectedProgram went_on(text, standing_at_zero(), MoveCorrector::AtViolation::go_on);
  CHECK(went_on.last.points.size() == 400);
  int of_x = 0;
  for (const machine::Violation& violation : went_on.last.violations) {
    if (violation.what != "X") continue;
    ++of_x;
    CHECK(violation.by_how_much > 99);
  }
  CHECK(of_x == 1);
}

TEST_CASE("a rapid may begin and end within the limits and leave them on its way") {
  Job job = standing_at_zero();
  job.program.start[index(Axis::Y)] = -150;
  const std::string text = "G21 G90\nG0 Y150\nM2\n";
  const CorrectedProgram within(text, job, MoveCorrector::AtViolation::stop);
  CHECK(within.last.violations.empty());
  job.model.limits.length_min[1] = 1.255;  // m; 1.251 in the middle, more than 1.257 at both ends
  const CorrectedProgram beyond(text, job, MoveCorrector::AtViolation::stop);
  CHECK(beyond.last.points.size() == 1);
  REQUIRE_FALSE(beyond.last.violations.empty());
  CHECK(beyond.last.violations.front().what == "strut 2");
}

TEST_CASE("axes that are taken to stand at zero get no shift") {
  const CorrectedProgram cut("G21 G90 G94\nG0 X0 Y0 Z0\nG1 X50 F100\nM2\n", {}, MoveCorrector::AtViolation::stop);
  for (const nc::CorrectedPoint& point : cut.last.points) {
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) CHECK(point.shift[axis] == 0);
    CHECK(point.shift[Axis::Z] != 0);
  }
}
