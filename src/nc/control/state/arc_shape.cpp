#include "nc/control/state/arc_shape.hpp"

#include <algorithm>
#include <numbers>

#include "base/units.hpp"

namespace plumbline::nc {
namespace {

constexpr double kTurnRad = 2 * std::numbers::pi;
constexpr double kClosedRad = 1e-9;  // rad; a circle that closes up to this is a full one

// Tolerances [LinuxCNC, measured with rs274]; lengths in mm, for a program in mm and for one in inches.
constexpr double kRadiusMm = 0.00127, kRadiusInch = 0.00005 * kMmPerInch;
constexpr double kSpiralMm = 0.0282842712, kSpiralInch = 0.00282842712 * kMmPerInch;
constexpr double kSpiralRelative = 1e-3;
constexpr double kSpiralLargest = 100;  // times the tolerance, whatever the radius

// The angle from alpha to beta in the sense of the turns, with the further full turns. [RS274/NGC, G2 and G3 with P]
// Where both lie at half a turn, one of them just before it and one just behind, the second full turn makes the circle.
double sweep_of(double alpha, double beta, int turns) {
  double sweep = beta - alpha;
  if (turns > 0) {
    while (sweep <= kClosedRad) sweep += kTurnRad;
    return sweep + (turns - 1) * kTurnRad;
  }
  while (sweep >= -kClosedRad) sweep -= kTurnRad;
  return sweep + (turns + 1) * kTurnRad;
}

}  // namespace

ArcShape arc_shape(const AxisWords& from, const AxisWords& to, const Arc& arc) {
  const PlaneAxes plane = axes_of(arc.plane);
  ArcShape shape;
  shape.centre = {arc.centre_mm[index(plane.first)], arc.centre_mm[index(plane.second)]};
  const double u0 = from[plane.first] - shape.centre[0];
  const double v0 = from[plane.second] - shape.centre[1];
  const double u1 = to[plane.first] - shape.centre[0];
  const double v1 = to[plane.second] - shape.centre[1];
  shape.start_radius = std::hypot(u0, v0);
  shape.end_radius = std::hypot(u1, v1);
  shape.start_angle = std::atan2(v0, u0);
  shape.sweep = sweep_of(shape.start_angle, std::atan2(v1, u1), arc.turns);
  shape.rise_mm = to[plane.third] - from[plane.third];
  return shape;
}

bool radii_agree(double start, double end, bool inches) {
  const double apart = std::abs(start - end);
  const double spiral = spiral_taken(inches);
  const bool far = apart > spiral && apart / std::max(start, end) > kSpiralRelative;
  return apart <= spiral * kSpiralLargest && !far;
}

double spiral_taken(bool inches) { return inches ? kSpiralInch : kSpiralMm; }

double least_radius(bool inches) { return inches ? kRadiusInch : kRadiusMm; }

}  // namespace plumbline::nc
