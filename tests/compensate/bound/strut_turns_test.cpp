#include "compensate/bound/strut_turns.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "compensate/bound/move_of_program.hpp"

using namespace plumbline;
using compensate::CorrectionCurve;
using compensate::PieceEnd;
using compensate::StrutTurns;

TEST_CASE("struts turn round where their speed passes through zero") {
  const MoveOfProgram program("G21 G90 G94 F1500\nG1 X-120\nG0 X-120 Y-100\nG1 X120 Y100 F1500\nM2\n", true);
  compensate::MoveReader reader = reader_of(program.opened);
  compensate::Move move = program.move;
  while (const compensate::Move* const read = reader.next_move()) move = *read;  // the diagonal
  CorrectionCurve curve(program.corrector, program.opened.job.model.limits);
  curve.follow(move, {});
  StrutTurns turns(program.corrector, curve);
  const std::vector<double> places = turns.follow(move, 1e-4);
  REQUIRE_FALSE(places.empty());
  CHECK(std::is_sorted(places.begin(), places.end()));
  const machine::PerStrut<double> first = curve.speeds(curve.place(0));
  const machine::PerStrut<double> last = curve.speeds(curve.place(1));
  const double v0 = program.corrector.turning_speed();
  std::size_t expected = 0;
  for (int j = 0; j < machine::kStruts; ++j) {
    if (first[j] * last[j] < 0) expected += 3;  // slow, turned, fast again
  }
  CHECK(places.size() >= expected);
  for (const double place : places) {
    double nearest = 1;  // of some strut to one of the three speeds, over v0
    const machine::PerStrut<double> speeds = curve.speeds(curve.place(place));
    for (int j = 0; j < machine::kStruts; ++j) {
      for (const double level : {-3.0, 0.0, 3.0}) nearest = std::min(nearest, std::abs(speeds[j] / v0 - level));
    }
    CHECK(nearest < 1e-3);
  }
  CHECK(turns.follow(move, 1.0).empty());  // no friction moves the tip by a millimetre
}

TEST_CASE("the friction of a strut that moves acts against its way, and what a turn moves is the tip's jump") {
  const MoveOfProgram program("G21 G90 G94\nG1 X30 Y12 Z-9 F1500\nM2\n", true);
  CorrectionCurve curve(program.corrector, program.opened.job.model.limits);
  curve.follow(program.move, {});
  StrutTurns turns(program.corrector, curve);
  turns.follow(program.move, 1e-4);
  const machine::PerStrut<double> speeds = curve.speeds(curve.place(1));
  const machine::PerStrut<double> sign = turns.sign_at_end({0, {}, machine::PerStrut<double>::Zero()}, 1);
  machine::PerStrut<double> turned = sign;
  for (int j = 0; j < machine::kStruts; ++j) {
    if (std::abs(speeds[j]) > 1e-4) CHECK(sign[j] == Approx(speeds[j] > 0 ? 1 : -1).margin(0.01));
  }
  CHECK(turns.tip_jump_mm(sign, turned) == 0);
  turned[2] = -turned[2];
  CHECK(turns.tip_jump_mm(sign, turned) == Approx(curve.friction().tip_mm[2]).epsilon(0.01));
}
