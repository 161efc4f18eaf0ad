// What an arc is in its plane: a circle, or a spiral where its radius changes from start to end.
#pragma once

#include <array>
#include <cmath>

#include "base/axes.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::nc {

/// In the plane of the arc, work system. The radius goes linearly with the angle.
struct ArcShape {
  std::array<double, 2> centre{};  // along the first and second axis of the plane, mm
  double start_angle = 0;          // rad
  double sweep = 0;                // rad, positive counter-clockwise
  double start_radius = 0;         // mm
  double end_radius = 0;
  double rise_mm = 0;  // along the normal of the plane

  /// Length of its circle. The radii agree to the control's tolerance, so the mean radius gives that of a spiral.
  double circle_mm() const { return (start_radius + end_radius) / 2 * std::abs(sweep); }
  /// The same with what it rises.
  double length_mm() const { return std::hypot((start_radius + end_radius) / 2 * sweep, rise_mm); }
};

ArcShape arc_shape(const AxisWords& from, const AxisWords& to, const Arc& arc);

/// Whether a control takes an arc with these radii at its start and its end, mm [LinuxCNC, measured with rs274];
/// `inches`: the unit of the program.
bool radii_agree(double start, double end, bool inches);
/// Radii that are no further apart always agree, mm.
double spiral_taken(bool inches);
/// The least radius of an arc, mm.
double least_radius(bool inches);

}  // namespace plumbline::nc
