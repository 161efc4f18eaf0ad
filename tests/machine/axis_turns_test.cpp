#include "machine/axis_turns.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

namespace {

using One = Lanes<AnyProcessor, 1>;

Vector3<double> plain(const Vector3<One>& v) { return {v[0][0], v[1][0], v[2][0]}; }
double largest(const Vector3<double>& v) { return v.cwiseAbs().maxCoeff(); }

constexpr const char* kAllOrders[] = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};

Vector3<double> angles(Random& random) {
  return {uniform(random, -7, 7), uniform(random, -7, 7), uniform(random, -7, 7)};
}

}  // namespace

TEST_CASE("sines and cosines of A, B, C make the orientation that the angles make, in every order") {
  Random random(5);
  for (const char* const text : kAllOrders) {
    const RotationOrder order = rotation_order(text).value();
    for (int n = 0; n < 100; ++n) {
      const Vector3<double> abc = angles(random);
      const Matrix3<One> R = rotation(order, axis_turns<One>(order, abc.cast<One>()));
      const Matrix3<double> wanted = rotation(order, abc);
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) CHECK(std::abs(R(i, k)[0] - wanted(i, k)) < 1e-15);
      }
    }
  }
}

TEST_CASE("rates of A, B, C make the angular velocity, and its derivative is the angular acceleration") {
  Random random(6);
  for (const char* const text : kAllOrders) {
    const RotationOrder order = rotation_order(text).value();
    for (int n = 0; n < 100; ++n) {
      const Vector3<double> abc = angles(random);
      const Vector3<double> rate = direction(random);
      const auto turned = turning<One>(order, axis_turns<One>(order, abc.cast<One>()), rate.cast<One>());
      CHECK(largest(plain(turned.velocity) - angular_velocity<double>(order, abc, rate)) < 1e-14);
      const double step = 1e-5;
      const Vector3<double> slope = (angular_velocity<double>(order, abc + step * rate, rate) -
                                     angular_velocity<double>(order, abc - step * rate, rate)) /
                                    (2 * step);
      CHECK(largest(plain(turned.acceleration) - slope) < 1e-9);
    }
  }
}

TEST_CASE("the change of A, B, C leads to the orientation, and says where it cannot be sure") {
  Random random(7);
  for (const char* const text : kAllOrders) {
    const RotationOrder order = rotation_order(text).value();
    int sure = 0;
    for (int n = 0; n < 500; ++n) {
      const Vector3<double> abc = angles(random);
      const double size = n % 2 == 0 ? 1e-3 : 0.2;
      const Vector3<double> there = abc + uniform(random, 0, size) * direction(random);
      const auto change =
          angle_change<One>(order, axis_turns<One>(order, abc.cast<One>()), rotation(order, there).cast<One>());
      if (!change.sure[0]) {
        const double middle = std::abs(std::cos(abc[order.axes[1]]));
        CHECK((size > 0.05 || middle < 0.02));
        continue;
      }
      ++sure;
      const Vector3<double> found = abc + plain(change.abc);
      CHECK((rotation(order, found) - rotation(order, there)).cwiseAbs().maxCoeff() < 1e-13);
      if (size < 0.05) CHECK(largest(found - there) < 1e-12);
    }
    CHECK(sure > 200);
  }
}
