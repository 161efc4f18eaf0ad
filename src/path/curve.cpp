#include "path/curve.hpp"

#include <cmath>

#include "base/units.hpp"

namespace plumbline::path {

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
  arc_ = nc::arc_shape(from_, to_, arc);
  linear_mm_ = arc_.length_mm();
}

double Curve::circle_mm() const { return arc_.circle_mm(); }

double Curve::arc_deg() const { return arc_.sweep / kDeg; }

AxisWords Curve::at(double fraction) const {
  if (fraction <= 0) return from_;
  if (fraction >= 1) return to_;
  AxisWords words;
  for (const Axis axis : kAllAxes) words[axis] = from_[axis] + fraction * delta_[axis];
  if (!is_arc_) return words;
  const double angle = arc_.start_angle + fraction * arc_.sweep;
  const double radius = arc_.start_radius + fraction * (arc_.end_radius - arc_.start_radius);
  words[plane_.first] = arc_.centre[0] + radius * std::cos(angle);
  words[plane_.second] = arc_.centre[1] + radius * std::sin(angle);
  return words;
}

CurvePoint Curve::point(double fraction) const {
  CurvePoint point{at(fraction), delta_, {}};
  if (!is_arc_) return point;
  const double angle = arc_.start_angle + fraction * arc_.sweep;
  const double radius = arc_.start_radius + fraction * (arc_.end_radius - arc_.start_radius);
  const double growth = arc_.end_radius - arc_.start_radius;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  point.slope[plane_.first] = growth * c - radius * arc_.sweep * s;
  point.slope[plane_.second] = growth * s + radius * arc_.sweep * c;
  point.bend[plane_.first] = -arc_.sweep * (2 * growth * s + radius * arc_.sweep * c);
  point.bend[plane_.second] = arc_.sweep * (2 * growth * c - radius * arc_.sweep * s);
  return point;
}

}  // namespace plumbline::path
