#include "path/curve.hpp"

#include <cmath>
#include <numbers>

#include "base/units.hpp"

namespace plumbline::path {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kSameAngle = 1e-9;  // rad; a circle that closes up to this is a full one

// The angle from alpha to beta in the sense of the turns, with the further full turns. [RS274/NGC, G2 and G3 with P]
// Where both lie at half a turn, one of them just before it and one just behind, the second full turn makes the circle.
double sweep_of(double alpha, double beta, int turns) {
  double sweep = beta - alpha;
  if (turns > 0) {
    while (sweep <= kSameAngle) sweep += kFullTurn;
    return sweep + (turns - 1) * kFullTurn;
  }
  while (sweep >= -kSameAngle) sweep -= kFullTurn;
  return sweep + (turns + 1) * kFullTurn;
}

}  // namespace

Curve::Curve(const nc::Motion& motion) : from_(motion.from), to_(motion.to), delta_(motion.to - motion.from) {
  if (motion.kind == nc::MotionKind::arc) {
    set_arc(motion.arc);
    return;
  }
  linear_mm_ = length_mm(delta_);
}

void Curve::set_arc(const nc::Arc& arc) {
  is_arc_ = true;
  plane_ = nc::axes_of(arc.plane);
  centre_ = {arc.centre_mm[index(plane_.first)], arc.centre_mm[index(plane_.second)]};
  const double u0 = from_[plane_.first] - centre_[0];
  const double v0 = from_[plane_.second] - centre_[1];
  const double u1 = to_[plane_.first] - centre_[0];
  const double v1 = to_[plane_.second] - centre_[1];
  start_radius_ = std::hypot(u0, v0);
  end_radius_ = std::hypot(u1, v1);
  start_angle_ = std::atan2(v0, u0);
  sweep_ = sweep_of(start_angle_, std::atan2(v1, u1), arc.turns);
  // The radii agree to the control's tolerance, so the mean radius gives the length of the spiral.
  linear_mm_ = std::hypot((start_radius_ + end_radius_) / 2 * sweep_, delta_[plane_.third]);
}

double Curve::circle_mm() const { return (start_radius_ + end_radius_) / 2 * std::abs(sweep_); }

double Curve::arc_deg() const { return sweep_ / kDeg; }

AxisWords Curve::at(double fraction) const {
  if (fraction <= 0) return from_;
  if (fraction >= 1) return to_;
  AxisWords words;
  for (const Axis axis : kAllAxes) words[axis] = from_[axis] + fraction * delta_[axis];
  if (!is_arc_) return words;
  const double angle = start_angle_ + fraction * sweep_;
  const double radius = start_radius_ + fraction * (end_radius_ - start_radius_);
  words[plane_.first] = centre_[0] + radius * std::cos(angle);
  words[plane_.second] = centre_[1] + radius * std::sin(angle);
  return words;
}

CurvePoint Curve::point(double fraction) const {
  CurvePoint point{at(fraction), delta_, {}};
  if (!is_arc_) return point;
  const double angle = start_angle_ + fraction * sweep_;
  const double radius = start_radius_ + fraction * (end_radius_ - start_radius_);
  const double growth = end_radius_ - start_radius_;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  point.slope[plane_.first] = growth * c - radius * sweep_ * s;
  point.slope[plane_.second] = growth * s + radius * sweep_ * c;
  point.bend[plane_.first] = -sweep_ * (2 * growth * s + radius * sweep_ * c);
  point.bend[plane_.second] = sweep_ * (2 * growth * c - radius * sweep_ * s);
  return point;
}

}  // namespace plumbline::path
