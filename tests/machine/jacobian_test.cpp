#include "machine/jacobian.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

TEST_CASE("the Jacobian is the derivative of the strut lengths by the displacement of the platform") {
  Random random(4);
  for (const MachineModel& model : three_machines()) {
    const Pose<double> pose = pose_within(model.limits, random);
    const Matrix6<double> J = jacobian(strut_geometry(model.geometry, pose));
    const double h = 1e-5;
    for (int a = 0; a < 6; ++a) {
      const Vector6<double> step = h * Vector6<double>::Unit(a);
      const PerStrut<double> later = strut_lengths(model.geometry, displaced<double>(pose, step));
      const PerStrut<double> before = strut_lengths(model.geometry, displaced<double>(pose, -step));
      CHECK(((later - before) / (2 * h) - J.col(a)).norm() < 1e-9);
    }
  }
}
