#include "compensate/bound/correction_curve.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "compensate/bound/move_of_program.hpp"
#include "path/figures.hpp"

using namespace plumbline;
using compensate::CorrectionCurve;
using compensate::PieceEnd;
using compensate::PieceProof;

namespace {

constexpr auto kAsTold = CorrectionCurve::Friction::as_told;

PieceEnd on_curve(CorrectionCurve& curve, double fraction) {
  const compensate::Corrected corrected = curve.command(curve.place(fraction), machine::PerStrut<double>::Zero());
  return {fraction, corrected.pose, machine::PerStrut<double>::Zero()};
}

// The furthest that a piece leaves the corrections of 200 of its points.
double furthest_mm(const MoveOfProgram& program, const PieceEnd& begin, const PieceEnd& end) {
  double furthest = 0;
  for (int i = 0; i <= 200; ++i) {
    const double along = i / 200.0;
    const double fraction = begin.fraction + along * (end.fraction - begin.fraction);
    const compensate::Target target = program.move.path.target(fraction, program.move.seconds);
    const AxisWords off = path::between(begin.told, end.told, along) - program.corrector.correct(target).pose;
    furthest = std::max(furthest, compensate::deviation(program.corrector, target, fraction, off).tip_mm);
  }
  return furthest;
}

}  // namespace

TEST_CASE("a proof finds what many points of a piece find, and little more") {
  for (const char* const text :
       {"G21 G90 G94\nG1 X120 Y-40 Z30 A6 B-9 F2000\nM2\n", "G21 G90 G94 G17\nG2 X30 Y0 I15 J0 A4 F500\nM2\n"}) {
    const MoveOfProgram program(text, false);
    CorrectionCurve curve(program.corrector, program.opened.job.model.limits);
    curve.follow(program.move, {});
    for (const double share : {0.05, 0.2, 0.6}) {
      const PieceEnd begin = on_curve(curve, 0.3);
      const PieceEnd end = on_curve(curve, 0.3 + share);
      const double found = curve.prove(begin, end, kAsTold).worst.tip_mm;
      const double there = furthest_mm(program, begin, end);
      INFO(text << share << ": proven " << found << " mm, there are " << there);
      CHECK(found >= there * 0.999);
      CHECK(found <= there * 1.4);
    }
    CHECK(curve.violations().empty());
  }
}

TEST_CASE("where the control stands off the correction the proof says so") {
  const MoveOfProgram program("G21 G90 G94\nG1 X20 F1000\nM2\n", false);
  CorrectionCurve curve(program.corrector, program.opened.job.model.limits);
  curve.follow(program.move, {});
  PieceEnd begin = on_curve(curve, 0);
  const PieceEnd end = on_curve(curve, 0.1);
  const double before = curve.prove(begin, end, kAsTold).worst.tip_mm;
  begin.told[Axis::Y] += 0.007;
  CHECK(curve.prove(begin, end, kAsTold).worst.tip_mm == Approx(before + 0.007).margin(1e-5));
}

TEST_CASE("rounding of words turns the tool by what the worst of their signs gives") {
  const MoveOfProgram program("G21 G90 G94\nG1 X20 A8 B-12 C5 F1000\nM2\n", false);
  const CorrectionCurve curve(program.corrector, program.opened.job.model.limits);
  const AxisWords half{{3e-4, 0, 4e-4, 0.001, 0.001, 0.001}};
  const compensate::Deviation rounding = curve.rounding(program.move, half);
  CHECK(rounding.tip_mm == Approx(5e-4));
  const AxisWords end = program.move.path.target(1, std::nullopt).pose;
  double most = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](int bit) { return (corner & (1 << bit)) != 0 ? 0.001 : -0.001; };
    const AxisWords off{{0, 0, 0, side(0), side(1), side(2)}};
    most = std::max(most, compensate::deviation(program.corrector, {end, {}, {}, std::nullopt}, 1, off).turned_rad);
  }
  CHECK(rounding.turned_rad >= most * (1 - 1e-9));
  CHECK(rounding.turned_rad <= most * 1.1);
  compensate::Move fixed = program.move;
  fixed.path.fixed = AxisSet::rotary();
  CHECK(curve.rounding(fixed, half).turned_rad == 0);
}

TEST_CASE("a piece whose struts may turn by rounding leaves more") {
  const MoveOfProgram program("G21 G90 G94\nG1 X20 F1000\nM2\n", true);
  CorrectionCurve curve(program.corrector, program.opened.job.model.limits);
  const auto proven = [&](const compensate::Deviation& rounding, double share) {
    curve.follow(program.move, rounding);
    const PieceEnd begin = on_curve(curve, 0.5);
    return curve.prove(begin, on_curve(curve, 0.5 + share), kAsTold).worst.tip_mm;
  };
  CHECK(proven({1e-2, 0}, 0.001) > proven({}, 0.001) + 1e-3);  // 10 um in 1.2 ms
  CHECK(proven({1e-5, 0}, 0.4) == Approx(proven({}, 0.4)).margin(1e-4));
}
