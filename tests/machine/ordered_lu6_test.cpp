#include "machine/ordered_lu6.hpp"

#include <catch2/catch.hpp>

#include "machine/jacobian.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

TEST_CASE("in the order of home the Jacobian is solved as with pivots of its own, over the workspace") {
  Random random(13);
  for (const MachineModel& model : three_machines()) {
    const RowOrder rows = pivot_order(jacobian(strut_geometry(model.geometry, home_pose(model))));
    int sound = 0;
    for (int n = 0; n < 500; ++n) {
      const Matrix6<double> J = jacobian(strut_geometry(model.geometry, pose_within(model.limits, random)));
      const OrderedLu6<double> ordered(J, rows);
      if (!ordered.sound()) continue;
      ++sound;
      const Lu6<double> pivoted(J);
      const Vector6<double> r = Vector6<double>::NullaryExpr([&] { return uniform(random, -1, 1); });
      const double scale = pivoted.solve(r).norm();
      CHECK((J * ordered.solve(r) - r).norm() < 1e-11 * (1 + scale));
      CHECK((J.transpose() * ordered.solve_transposed(r) - r).norm() <
            1e-11 * (1 + pivoted.solve_transposed(r).norm()));
    }
    CHECK(sound > 450);
  }
}

TEST_CASE("an order that does not suit a matrix, or a singular one, is not sound") {
  Matrix6<double> A = Matrix6<double>::Identity();
  const RowOrder straight = pivot_order(A);
  CHECK(OrderedLu6<double>(A, straight).sound());
  std::swap(A(0, 0), A(1, 0));
  std::swap(A(0, 1), A(1, 1));
  CHECK_FALSE(OrderedLu6<double>(A, straight).sound());
  CHECK(OrderedLu6<double>(A, pivot_order(A)).sound());
  A(5, 5) = 0;
  CHECK_FALSE(OrderedLu6<double>(A, pivot_order(A)).sound());
  A(5, 5) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(OrderedLu6<double>(A, straight).sound());
}
