#include "machine/orientation.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::machine;
using namespace plumbline::testing;

namespace {

constexpr const char* kOrders[] = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};

Matrix3<double> by_eigen(const std::string& order, const Vector3<double>& abc) {
  Matrix3<double> R = Matrix3<double>::Identity();
  for (const char axis : order) {
    R = R * Eigen::AngleAxisd(abc[axis - 'X'], Vector3<double>::Unit(axis - 'X')).toRotationMatrix();
  }
  return R;
}

}  // namespace

TEST_CASE("each order composes its axes from left to right") {
  const Vector3<double> abc(0.3, -0.7, 1.9);
  for (const char* order : kOrders) {
    INFO(order);
    CHECK((rotation(rotation_order(order).value(), abc) - by_eigen(order, abc)).norm() < 1e-15);
    CHECK(to_text(*rotation_order(order)) == order);
  }
  for (const char* bad : {"", "XY", "XXY", "XYX", "ABC", "xyz", "XYZX"}) CHECK_FALSE(rotation_order(bad));
}

TEST_CASE("A, B, C come back nearest to the reference, from either solution and any turn") {
  Random random(1);
  for (const char* name : kOrders) {
    const RotationOrder order = rotation_order(name).value();
    for (int n = 0; n < 300; ++n) {
      const Vector3<double> abc(uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9));
      const Vector3<double> reference = abc + 0.05 * direction(random);
      const Angles found = nearest_angles(order, rotation(order, abc), reference);
      INFO(name << " " << abc.transpose());
      const bool near_lock = std::abs(std::cos(abc[order.axes[1]])) < 0.1;
      if (!near_lock) CHECK((found.abc - abc).norm() < 1e-12);
      CHECK((rotation(order, found.abc) - rotation(order, abc)).norm() < 1e-12);
    }
  }
}

TEST_CASE("in gimbal lock the leftmost angle stays and the orientation is met") {
  for (const char* name : kOrders) {
    for (const double side : {-1.0, 1.0}) {
      const RotationOrder order = rotation_order(name).value();
      Vector3<double> abc(0.4, 0.4, 0.4);
      abc[order.axes[1]] = side * std::numbers::pi / 2;
      Vector3<double> reference = abc;
      reference[order.axes[0]] = 0.1;
      const Angles found = nearest_angles(order, rotation(order, abc), reference);
      CHECK(found.gimbal_lock);
      CHECK(found.abc[order.axes[0]] == 0.1);
      CHECK((rotation(order, found.abc) - rotation(order, abc)).norm() < 1e-12);
    }
  }
}

TEST_CASE("the angular velocity is the derivative of the rotation") {
  const Vector3<double> abc(0.3, -0.7, 1.9);
  const Vector3<double> rate(0.5, 1.1, -0.4);
  for (const char* name : kOrders) {
    const RotationOrder order = rotation_order(name).value();
    const double h = 1e-6;
    const Matrix3<double> later = rotation<double>(order, abc + h * rate);
    const Matrix3<double> before = rotation<double>(order, abc - h * rate);
    const Matrix3<double> S = (later - before) / (2 * h) * rotation(order, abc).transpose();
    CHECK((S - skew(angular_velocity(order, abc, rate))).norm() < 1e-9);
  }
}

TEST_CASE("exponential and logarithm undo each other from nothing to nearly half a turn") {
  Random random(2);
  for (const double size : {0.0, 1e-12, 1e-7, 9.99e-3, 1.01e-2, 0.1, 1.0, 3.0, 3.14}) {
    const Vector3<double> w = size * direction(random);
    INFO(size);
    const Matrix3<double> R = exponential(w);
    CHECK(
        (R - Eigen::AngleAxisd(size, size > 0 ? w.normalized() : Vector3<double>::UnitX()).toRotationMatrix()).norm() <
        1e-15 * 4);
    CHECK((R.transpose() * R - Matrix3<double>::Identity()).norm() < 1e-15 * 4);
    CHECK((logarithm(R) - w).norm() <= 1e-13 + (size > 3 ? 1e-12 : 0));
    if (size <= 1e-2) CHECK((small_rotation(w) - R).norm() < 1e-16 + std::pow(size, 6));
  }
}
