#include "machine/lu6.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

namespace {

Matrix6<double> random_matrix(Random& random) {
  return Matrix6<double>::NullaryExpr([&] { return uniform(random, -1, 1); });
}

}  // namespace

TEST_CASE("solutions and determinant agree with a library's") {
  Random random(5);
  for (int n = 0; n < 2000; ++n) {
    const Matrix6<double> A = random_matrix(random);
    const Vector6<double> r = random_matrix(random).col(0);
    const Lu6<double> lu(A);
    const Eigen::FullPivLU<Matrix6<double>> library(A);
    const double scale = 1e-12 * library.solve(r).norm() / std::min(1.0, std::abs(A.determinant()));
    CHECK_FALSE(lu.singular());
    CHECK((A * lu.solve(r) - r).norm() < scale + 1e-12);
    CHECK((A.transpose() * lu.solve_transposed(r) - r).norm() < scale + 1e-12);
    CHECK(std::abs(lu.determinant() - A.determinant()) < 1e-13);
  }
}

TEST_CASE("a zero on the diagonal is no obstacle") {
  Matrix6<double> A = Matrix6<double>::Zero();
  for (int i = 0; i < 6; ++i) A(i, (i + 1) % 6) = i + 1;
  const Lu6<double> lu(A);
  const Vector6<double> r = Vector6<double>::LinSpaced(1, 6);
  CHECK((A * lu.solve(r) - r).norm() < 1e-14);
  CHECK((A.transpose() * lu.solve_transposed(r) - r).norm() < 1e-14);
  CHECK(std::abs(lu.determinant() - A.determinant()) < 1e-10);
}

TEST_CASE("a singular matrix is stated and its solutions are finite") {
  Random random(6);
  Matrix6<double> A = random_matrix(random);
  A.row(4) = A.row(1) - 2 * A.row(2);
  for (const Matrix6<double>& bad : {A, Matrix6<double>(Matrix6<double>::Zero())}) {
    const Lu6<double> lu(bad);
    CHECK(lu.singular());
    CHECK(lu.solve(Vector6<double>::Ones()).allFinite());
    CHECK(lu.solve_transposed(Vector6<double>::Ones()).allFinite());
  }
  A(3, 3) = std::numeric_limits<double>::quiet_NaN();
  CHECK(Lu6<double>(A).singular());
}

TEST_CASE("each lane of a pack is solved as alone, singular ones beside sound ones") {
  Random random(7);
  Matrix6<Pack> A;
  Vector6<Pack> r;
  std::vector<Matrix6<double>> lanes;
  std::vector<Vector6<double>> sides;
  for (int lane = 0; lane < Pack::size(); ++lane) {
    lanes.push_back(random_matrix(random));
    if (lane == 0) lanes[0].col(5).setZero();
    sides.emplace_back(random_matrix(random).col(0));
    for (int i = 0; i < 6; ++i) {
      r[i].set(lane, sides.back()[i]);
      for (int k = 0; k < 6; ++k) A(i, k).set(lane, lanes.back()(i, k));
    }
  }
  const Lu6<Pack> lu(A);
  const Vector6<Pack> x = lu.solve(r);
  const Vector6<Pack> y = lu.solve_transposed(r);
  for (int lane = 0; lane < Pack::size(); ++lane) {
    const Lu6<double> alone(lanes[static_cast<std::size_t>(lane)]);
    const Vector6<double>& side = sides[static_cast<std::size_t>(lane)];
    CHECK(lu.singular()[lane] == alone.singular());
    for (int i = 0; i < 6; ++i) {
      CHECK(x[i][lane] == alone.solve(side)[i]);
      CHECK(y[i][lane] == alone.solve_transposed(side)[i]);
    }
    CHECK(lu.determinant()[lane] == alone.determinant());
  }
}
