#include "physics/motion.hpp"

#include <catch2/catch.hpp>

#include "machine/displacement.hpp"
#include "physics/moments.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

// Where a motion has come after `dt`: exact to the second order.
Pose<double> after(const Motion<double>& m, double dt) {
  machine::Vector6<double> way;
  way << m.twist.v_WT * dt + 0.5 * dt * dt * m.acceleration.v_WT,
      m.twist.w_WP * dt + 0.5 * dt * dt * m.acceleration.w_WP;
  return machine::displaced(m.pose, way);
}

}  // namespace

TEST_CASE("speeds and accelerations of the struts are the derivatives of their lengths") {
  Random random(30);
  const machine::MachineModel model = pm600_like();
  for (int n = 0; n < 50; ++n) {
    const Motion<double> motion = moment_within(model.limits, random);
    const auto lengths = [&](double t) { return machine::strut_lengths(model.geometry, after(motion, t)); };
    const auto rates = strut_rates(machine::strut_geometry(model.geometry, motion.pose), motion, {});
    const double h = 1e-3;
    CHECK(((lengths(h) - lengths(-h)) / (2 * h) - rates.speed).norm() < 1e-6);
    CHECK(((lengths(h) - 2 * lengths(0) + lengths(-h)) / (h * h) - rates.acceleration).norm() < 1e-6);
  }
}

TEST_CASE("the sign of a speed is smooth, odd and saturates; at rest and without friction all is silent") {
  const machine::MachineModel model = pm600_like();
  Motion<double> motion;
  motion.pose = machine::home_pose(model);
  const auto struts = machine::strut_geometry(model.geometry, motion.pose);
  CHECK(strut_rates(struts, motion, {}).sign.isZero(0));
  motion.twist.v_WT = {0, 0, 1};
  const auto up = strut_rates(struts, motion, {});
  motion.twist.v_WT = {0, 0, -1};
  const auto down = strut_rates(struts, motion, {});
  CHECK(up.sign == -down.sign);
  CHECK(up.sign.cwiseAbs().isApproxToConstant(1));
  const auto off = strut_rates(struts, motion, {.friction = false});
  CHECK(off.sign.isZero(0));
  CHECK(off.speed.isZero(0));
  CHECK(off.transverse.isZero(0));
}
