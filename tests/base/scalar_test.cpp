#include "base/scalar.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace plumbline;

TEST_CASE("a pack chooses, swaps and compares lane by lane, as double does alone") {
  Pack a;
  Pack b;
  for (int lane = 0; lane < Pack::size(); ++lane) {
    a.set(lane, lane - 1.5);
    b.set(lane, 1.0 - lane);
  }
  Pack x = a;
  Pack y = b;
  swap_where<Pack>(a < b, x, y);
  for (int i = 0; i < Pack::size(); ++i) {
    const double p = a[i];
    const double q = b[i];
    double u = p;
    double v = q;
    swap_where<double>(p < q, u, v);
    CHECK(select<Pack>(a < b, a, b)[i] == select<double>(p < q, p, q));
    CHECK(x[i] == u);
    CHECK(y[i] == v);
    CHECK(absolute(a)[i] == absolute(p));
    CHECK(larger(a, b)[i] == larger(p, q));
  }
  CHECK(any(a < Pack(-1.0)));
  CHECK_FALSE(all(b < Pack(0.5)));
}

TEST_CASE("what is no number is the larger one, on either side") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(larger(1.0, nan)));
  CHECK(std::isnan(larger(nan, 1.0)));
  CHECK(larger(2.0, 1.0) == 2.0);
  CHECK(std::isnan(larger(Pack(1.0), Pack(nan))[0]));
  CHECK(std::isnan(larger(Pack(nan), Pack(1.0))[0]));
}

TEST_CASE("Eigen holds packs") {
  using Vector = Eigen::Matrix<Pack, 3, 1>;
  const Vector v(Pack(1.0), Pack(2.0), Pack(2.0));
  CHECK(all(v.norm() == Pack(3.0)));
  CHECK(all(v.cross(Vector::UnitX())[1] == Pack(2.0)));
}
