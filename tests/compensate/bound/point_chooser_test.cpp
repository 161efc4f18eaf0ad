#include "compensate/bound/point_chooser.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "compensate/bound/move_of_program.hpp"

using namespace plumbline;
using compensate::BoundSettings;
using compensate::ChosenPoint;
using compensate::PointChooser;

namespace {

BoundSettings within_um(double um) {
  BoundSettings settings;
  settings.tolerance_mm = um * kUm / kMm;
  return settings;
}

constexpr const char* kArc = "G21 G90 G94 G17\nG2 X20 Y0 I10 J0 F1000\nM2\n";  // 31.4 mm in 1.9 s

}  // namespace

TEST_CASE("points go with the square root of the bound, and the last is the end of the move") {
  const MoveOfProgram program(kArc, false);
  std::size_t before = 0;
  for (const double um : {16.0, 4.0, 1.0}) {
    PointChooser chooser(program.corrector, program.opened.job.model.limits, within_um(um));
    const std::span<const ChosenPoint> points = chooser.choose(program.move, {});
    REQUIRE(chooser.reached());
    CHECK(points.back().place.fraction == 1);
    CHECK(chooser.bound().by_time.pieces == 0);
    CHECK(chooser.bound().kept_mm <= um * kUm / kMm);
    CHECK(chooser.bound().kept_mm >= 0.6 * um * kUm / kMm);
    if (before > 0) CHECK(points.size() == Approx(2.0 * static_cast<double>(before)).epsilon(0.1));
    before = points.size();
  }
  CHECK(before > 30);  // an arc of radius 10 mm leaves its chord of 0.28 mm by 1 um
  CHECK(before < 130);
}

TEST_CASE("no piece is shorter than the control's time, unless that yields") {
  const MoveOfProgram program(kArc, false);
  BoundSettings settings = within_um(0.5);
  settings.least_time_s = 0.1;
  PointChooser chooser(program.corrector, program.opened.job.model.limits, settings);
  double from = 0;
  for (const ChosenPoint& point : chooser.choose(program.move, {})) {
    CHECK((point.place.fraction - from) * *program.move.seconds >= 0.1);
    from = point.place.fraction;
  }
  CHECK(chooser.bound().by_time.pieces >= 15);
  CHECK(chooser.bound().by_time.off_mm.value > 0.01);
  CHECK(chooser.bound().by_time.off_mm.line == 2);
  CHECK(chooser.bound().by_time.seconds == Approx(*program.move.seconds).epsilon(0.01));
  settings.yields = BoundSettings::Yields::time;
  PointChooser patient(program.corrector, program.opened.job.model.limits, settings);
  CHECK(patient.choose(program.move, {}).size() > 80);
  CHECK(patient.bound().by_time.pieces == 0);
}

TEST_CASE("a control that stands elsewhere goes over in the shortest piece") {
  const MoveOfProgram program("G21 G90 G94\nG1 X20 F1000\nM2\n", true);
  PointChooser chooser(program.corrector, program.opened.job.model.limits, within_um(0.5));
  const ChosenPoint end = chooser.choose(program.move, {}).back();
  compensate::ControlBefore before;
  before.sign = -end.corrected.sign;  // as if it came the other way
  compensate::Target turned = program.move.path.target(0, program.move.seconds);
  turned.sign = before.sign;
  before.told = program.corrector.correct(turned).pose;
  const std::span<const ChosenPoint> points = chooser.choose(program.move, before);
  REQUIRE(points.size() >= 2);
  CHECK(points.front().place.fraction * *program.move.seconds == Approx(1e-3).epsilon(0.05));
  CHECK(chooser.bound().at_turns.pieces == 1);
  CHECK(chooser.bound().at_turns.off_mm.value > 0.005);
  CHECK(chooser.bound().by_time.pieces == 0);
  BoundSettings settings = within_um(0.5);
  settings.yields = BoundSettings::Yields::time;  // no shorter piece takes the jump away
  PointChooser patient(program.corrector, program.opened.job.model.limits, settings);
  CHECK(patient.choose(program.move, before).front().place.fraction == points.front().place.fraction);
}

TEST_CASE("a bound below what rounding leaves is refused") {
  const MoveOfProgram program(kArc, false);
  PointChooser chooser(program.corrector, program.opened.job.model.limits, within_um(0.5));
  compensate::ControlBefore before;
  before.words.half_quanta = {{5e-4, 5e-4, 5e-4, 0, 0, 0}};
  const Diagnostic said = testing::refusal_of([&] { chooser.choose(program.move, before); });
  CHECK(said.code == "compensate-tolerance");
  CHECK(said.place.line == 2);
  CHECK(said.message.find("0.893 um") != std::string::npos);
}
