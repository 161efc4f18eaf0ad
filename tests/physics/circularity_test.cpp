// The simulated circular tests of tests/golden/README.md: the whole chain with friction, against an independent
// program.
#include <Eigen/QR>
#include <catch2/catch.hpp>

#include "machine/axis_words.hpp"
#include "machine/machines.hpp"
#include "physics/error.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

constexpr int kPoints = 720;
constexpr double kRadius = 144 * kMm;
constexpr double kBar = 150 * kMm;
constexpr double kFeed = 1000 * kMmPerMin;

// Circularity (m) of one turn, counterclockwise, read by a bar whose other ball lies below the circle's plane.
double circularity(const machine::MachineModel& machine, const AxisWords& centre) {
  const ForceModel model(machine);
  const Pose<double> middle = machine::pose_of(machine.rotation, centre);
  const double below = std::sqrt(kBar * kBar - kRadius * kRadius);
  const Vector3<double> ball = middle.p_WT - Vector3<double>(0, 0, below);
  const double turning = kFeed / kRadius;  // rad/s
  Eigen::VectorXd reading(kPoints);
  Eigen::MatrixX3d first_harmonic(kPoints, 3);
  for (int n = 0; n < kPoints; ++n) {
    const double angle = 2 * std::numbers::pi * n / kPoints;
    const Vector3<double> outward(std::cos(angle), std::sin(angle), 0);
    Motion<double> motion;
    motion.pose = {middle.p_WT + kRadius * outward, middle.R_WP};
    motion.twist.v_WT = kFeed * Vector3<double>(-outward.y(), outward.x(), 0);
    motion.acceleration.v_WT = -turning * turning * kRadius * outward;
    const TipError<double> error = tip_error(model, model.environment(), motion);
    REQUIRE(error.converged());
    reading[n] = (error.pose.p_WT - ball).norm() - kBar;
    first_harmonic.row(n) << 1, outward.x(), outward.y();
  }
  const Eigen::VectorXd rest = reading - first_harmonic * first_harmonic.colPivHouseholderQr().solve(reading);
  return rest.maxCoeff() - rest.minCoeff();
}

struct Case {
  AxisWords centre;
  double circularity_um;
  double margin_um;
};

}  // namespace

TEST_CASE("the circularities of an independent program come out of the whole chain") {
  const machine::MachineModel machine = pm600_like();
  const std::vector<Case> cases{
      {{{0, 100, -1008, -25, 0, 0}}, 208, 2}, {{{0, 100, -1008, -23, 0, 0}}, 126, 2},
      {{{0, 100, -1008, -20, 0, 0}}, 71, 1},  {{{0, 100, -1008, -10, 0, 0}}, 20, 1},
      {{{0, 100, -1008, 0, 0, 0}}, 8.4, 1},   {{{0, 100, -1008, 10, 0, 0}}, 8.8, 1},
      {{{0, 100, -1008, 20, 0, 0}}, 15.0, 1}, {{{-70, -70, -1008, -17, -17, 0}}, 123, 2},
  };
  for (const Case& test : cases) {
    const double found = circularity(machine, test.centre) / kUm;
    INFO("A = " << test.centre[Axis::A] << ": " << found);
    CHECK(found == Approx(test.circularity_um).margin(test.margin_um).epsilon(0));
  }
}
