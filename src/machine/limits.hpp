// Whether a pose lies where the machine may go.
#pragma once

#include <string>
#include <vector>

#include "base/units.hpp"
#include "machine/model.hpp"

namespace plumbline::machine {

/// One limit that a pose breaks; value, limit and by_how_much in `unit`.
struct Violation {
  std::string what;  // "tilt", "X", "strut 3", "condition"
  double value = 0;
  double limit = 0;
  double by_how_much = 0;  // how far value lies beyond limit, positive
  std::string unit;
};

/// "strut 3 would be 1903.2 mm, 3.2 mm beyond its limit of 1900 mm"
std::string to_text(const Violation& violation);

inline constexpr double kTiltTolerance = 1e-6 * kDeg;

/// Angle between Z of P and Z of W, rad.
double tilt(const Matrix3<double>& R_WP);

/// Of a pose that a program asks for: its tilt against tilt_deg. Empty if it is within.
std::vector<Violation> check_programmed(const Limits& limits, const Pose<double>& pose);

/// Of a pose that the machine is sent to: tilt against tilt_deg plus the allowance, travel, strut lengths and the
/// condition number of J. Empty if all are within.
std::vector<Violation> check_compensated(const Limits& limits, const Geometry& geometry, const Pose<double>& pose);

}  // namespace plumbline::machine
