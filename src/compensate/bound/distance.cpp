#include "compensate/bound/distance.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::compensate {
namespace {

constexpr double kLeastWayMm = 1e-9;

Vector3<double> tip_part(const AxisWords& words) { return {words[Axis::X], words[Axis::Y], words[Axis::Z]}; }

double tip_mm(const Target& target, double fraction, const Vector3<double>& off) {
  const Vector3<double> slope = tip_part(target.slope);
  const double length = slope.norm();
  if (length < kLeastWayMm) return off.norm();
  const Vector3<double> tangent = slope / length;
  const double along = off.dot(tangent);
  const Vector3<double> bend = tip_part(target.bend);
  const double curvature = (bend - tangent * tangent.dot(bend)).norm() / (length * length);  // 1/mm
  const double beyond = std::max({0.0, -along - fraction * length, along - (1 - fraction) * length});
  return std::hypot((off - along * tangent).norm() + curvature * along * along / 2, beyond);
}

}  // namespace

Deviation deviation(const Corrector& corrector, const Target& target, double fraction, const AxisWords& off) {
  return {tip_mm(target, fraction, tip_part(off)), corrector.turn_rad(target.pose, off)};
}

}  // namespace plumbline::compensate
