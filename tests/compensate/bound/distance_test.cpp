#include "compensate/bound/distance.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "compensate/play.hpp"

using namespace plumbline;
using compensate::deviation;
using compensate::Target;

namespace {

const compensate::Corrector& some_corrector() {
  static const machine::MachineModel model = pm600();
  static const compensate::Settings settings;
  static const compensate::Corrector corrector(model, settings);
  return corrector;
}

double tip_mm(const Target& target, double fraction, const AxisWords& off) {
  return deviation(some_corrector(), target, fraction, off).tip_mm;
}

}  // namespace

TEST_CASE("what leads along the path is not off it, but for its curvature and its ends") {
  Target line{{{0, 0, -1008, 0, 0, 0}}, {{10, 0, 0, 0, 0, 0}}, {}, std::nullopt};
  CHECK(tip_mm(line, 0.5, {{0.002, 0.003, 0.004, 0, 0, 0}}) == Approx(0.005));
  CHECK(tip_mm(line, 0.5, {{0.02, 0, 0, 0, 0, 0}}) == Approx(0).margin(1e-12));
  CHECK(tip_mm(line, 1, {{0.002, 0, 0, 0, 0, 0}}) == Approx(0.002));  // beyond its end
  CHECK(tip_mm(line, 1, {{-0.002, 0, 0, 0, 0, 0}}) == Approx(0).margin(1e-12));
  CHECK(tip_mm(line, 0, {{-0.002, 0.0015, 0, 0, 0, 0}}) == Approx(0.0025));
  line.bend = {{0, 100, 0, 0, 0, 0}};  // 1/mm
  CHECK(tip_mm(line, 0.5, {{0.02, 0, 0, 0, 0, 0}}) == Approx(0.02 * 0.02 / 2));
  const Target turn{{{0, 0, -1008, 0, 0, 0}}, {{0, 0, 0, 5, 0, 0}}, {}, std::nullopt};
  CHECK(tip_mm(turn, 0.5, {{0.002, 0, 0, 0, 0, 0}}) == Approx(0.002));
}

TEST_CASE("orientations are compared as angles") {
  const Target target{{{0, 0, -1008, 5, -8, 10}}, {{10, 0, 0, 0, 0, 0}}, {}, std::nullopt};
  const AxisWords off{{0, 0, 0, 0.001, -0.002, 0.003}};
  const Matrix3<double> from = some_corrector().pose_of(target.pose).R_WP;
  const Matrix3<double> to = some_corrector().pose_of(target.pose + off).R_WP;
  const double angle = machine::logarithm<double>(to * from.transpose()).norm();
  CHECK(deviation(some_corrector(), target, 0.5, off).turned_rad == Approx(angle).epsilon(1e-4));
}
