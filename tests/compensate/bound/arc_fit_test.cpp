// With it told_way.cpp: how the control goes along what was fitted.
#include "compensate/bound/arc_fit.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "compensate/bound/move_of_program.hpp"
#include "compensate/bound/told_way.hpp"

using namespace plumbline;
using compensate::ArcFit;
using compensate::CorrectionCurve;
using compensate::PieceEnd;

namespace {

constexpr const char* kQuarter = "G21 G90 G94 G17\nG0 X20\nG3 X0 Y20 I-20 J0 F1000\nM2\n";

nc::ArcForm form() { return {AxisSet::all(), 0.014, 5e-5, 0.05, true}; }

struct Fitted {
  explicit Fitted(const std::string& text, const nc::ArcForm& how = form())
      : program(text, false), curve(program.corrector, program.opened.job.model.limits), fit(curve) {
    curve.follow(program.move, {});
    fit.follow(program.move, how);
  }
  PieceEnd on_curve(double fraction) {
    const auto none = machine::PerStrut<double>::Zero();
    return {fraction, curve.command(curve.place(fraction), none).pose, none};
  }
  double left_mm(const PieceEnd& begin, const PieceEnd& end) {
    return curve.prove(begin, end, CorrectionCurve::Friction::as_told).worst.tip_mm;
  }

  MoveOfProgram program;
  CorrectionCurve curve;
  ArcFit fit;
};

}  // namespace

TEST_CASE("the arc that is fitted leaves less than the arc of the program moved with its ends") {
  Fitted f(kQuarter);
  const PieceEnd begin = f.on_curve(0);
  PieceEnd end = f.on_curve(1);
  end.arc = f.fit.between(begin, end);
  REQUIRE(end.arc);
  const double fitted = f.left_mm(begin, end);
  CHECK(fitted < 0.002);
  for (const double by : {-0.002, 0.002}) {
    PieceEnd other = end;
    other.arc->centre_mm[0] += by;
    other.arc->centre_mm[1] += by;
    CHECK(f.left_mm(begin, other) > fitted);
  }
  end.arc.reset();
  CHECK(f.left_mm(begin, end) > 5);  // its chord
}

TEST_CASE("what is told along an arc goes on it, in all axes at once") {
  const MoveOfProgram program("G21 G90 G94 G17\nG0 X20\nG3 X0 Y20 Z4 A2 I-20 J0 F1000\nM2\n", false);
  const compensate::MovePath& path = program.move.path;
  const AxisWords begin = path.pose(0.25);
  const AxisWords end = path.pose(0.75);
  nc::Arc arc = program.move.motion->arc;
  const compensate::ToldWay way(path, begin, end, 0.5, arc);
  for (const double along : {0.0, 0.3, 1.0}) {
    const compensate::Target there = path.target(0.25 + along / 2, std::nullopt);
    for (const Axis axis : kAllAxes) {
      CHECK(way.pose(along)[axis] == Approx(there.pose[axis]).margin(1e-9));
      CHECK(way.slope(along)[axis] == Approx(there.slope[axis]).margin(1e-9));
    }
  }
}

TEST_CASE("no arc is fitted whose words could mean another one") {
  Fitted f(kQuarter);
  const PieceEnd begin = f.on_curve(0.5);
  CHECK(f.fit.between(begin, f.on_curve(0.6)));
  CHECK_FALSE(f.fit.between(begin, f.on_curve(0.50005)));  // 1.6 um
  CHECK_FALSE(f.fit.is_long(0.0005));
  CHECK(f.fit.is_long(0.1));
  Fitted small("G21 G90 G94 G17\nG0 X0.02\nG3 X0 Y0.02 I-0.02 J0 F1000\nM2\n");
  CHECK_FALSE(small.fit.is_asked());
  nc::ArcForm strict = form();
  strict.radii_apart_mm = 0;
  Fitted none(kQuarter, strict);
  CHECK_FALSE(none.fit.between(none.on_curve(0), none.on_curve(1)));
}

TEST_CASE("a whole circle ends where it begins, and is one arc only as a whole") {
  const char* const circle = "G21 G90 G94 G17\nG0 X20\nG3 I-20 J0 F1000\nM2\n";
  Fitted f(circle);
  CHECK(f.fit.most_share(0) == 1);
  CHECK(f.fit.most_share(0.01) == Approx(0.9));
  const PieceEnd begin = f.on_curve(0);
  PieceEnd end = f.on_curve(1);
  end.told[Axis::X] += 0.003;
  end.told = f.fit.end_of(begin, 1, end.told);
  CHECK(end.told[Axis::X] == begin.told[Axis::X]);
  CHECK(f.fit.between(begin, end));
  nc::ArcForm between_words = form();
  between_words.may_close = false;
  Fitted open(circle, between_words);
  CHECK(open.fit.most_share(0) == Approx(0.9));
  CHECK_FALSE(open.fit.between(begin, end));
}

TEST_CASE("words that may not stand beside an arc stay as they are") {
  nc::ArcForm plain = form();
  plain.beside = {Axis::Z};
  Fitted f(kQuarter, plain);
  const PieceEnd begin = f.on_curve(0);
  const AxisWords told = f.on_curve(1).told;
  const AxisWords end = f.fit.end_of(begin, 1, told);
  CHECK(end[Axis::A] == begin.told[Axis::A]);
  CHECK(end[Axis::Z] == told[Axis::Z]);
  CHECK(end[Axis::X] == told[Axis::X]);
}

TEST_CASE("rounding of a centre shows little on a short arc") {
  Fitted f(kQuarter);
  CHECK(f.fit.rounding_mm(1) <= 1.5 * 5e-5);
  CHECK(f.fit.rounding_mm(0.1) < 5e-7);
}
