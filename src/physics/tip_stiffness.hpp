// How far the tip gives way where a force pushes it.
#pragma once

#include "physics/error.hpp"

namespace plumbline::physics {

struct TipStiffnessOptions {
  double force = 10;  // N that the tip is pushed with, to both sides, for the derivative
};

/// The compliance of the tip, m/N in W: column a is how far it moves for each newton along axis a, at the working loads
/// of `error`, the converged error of `motion`. dx = J^-1 dL(t + J^-T F) + what no strut makes: every effect that gives
/// way counts, and what is bent counts at its slope there. That struts turn as the tip gives way is left out: their
/// tension over their length is a millionth of their stiffness.
Matrix3<double> tip_compliance(const ForceModel& model, const Environment& environment, const Motion<double>& motion,
                               const TipError<double>& error, const TipStiffnessOptions& options = {});

/// The stiffness in the direction in which it is least, N/m; infinite where nothing gives way.
double least_stiffness(const Matrix3<double>& compliance);

}  // namespace plumbline::physics
