// The error at the tool tip: where the machine stands when it is sent to a pose.
#pragma once

#include <string_view>

#include "machine/displacement.hpp"
#include "physics/strut_stretch.hpp"

namespace plumbline::physics {

enum class ErrorStop {
  converged,
  too_many_iterations,  // the loads grow as the machine gives way: it stands too near a singularity
  singular,             // the commanded pose is
  fell_through,         // the machine gives way through a singularity
};
std::string_view to_text(ErrorStop stop);

struct ErrorOptions {
  double tolerance_m = 1e-12;  // of the last step, rotations times a metre
  int most_iterations = 60;
  bool first_order = false;  // the loads at the commanded pose and dx = J^-1 dL, as the paper has it
};

template <class T>
struct TipError {
  Pose<T> pose;                      // where the machine stands
  machine::Vector6<T> displacement;  // dT: tip (m) and rotation vector (rad) from the commanded pose, in W
  StrutStretch<T> loads;             // there (first order: at the commanded pose)
  int iterations = 0;
  T residual_m = T(0.0);  // largest component of the last step, radians times a metre
  ErrorStop stopped_because = ErrorStop::converged;

  bool converged() const { return stopped_because == ErrorStop::converged; }
};

/// dT = FK(IK(T) + dL(T + dT)) - T, a fixed point: loads act where the machine stands, the speeds of the struts are
/// those of the commanded path at the commanded pose T  [docs/physics.md]. Each step takes loads and Jacobian where the
/// machine was thought to stand and solves J dx = IK(T) + dL - L there: Newton's method for the forward kinematics and
/// the fixed point in one. Of a pack, all lanes stop together. A result that has not converged must not be used.
template <class T>
TipError<T> tip_error(const ForceModel& model, const Parameter<T>* parameters, const Environment& environment,
                      const Motion<T>& motion, const ErrorOptions& options = {}) {
  const machine::Geometry& geometry = model.machine.geometry;
  const machine::StrutGeometry<T> commanded = machine::strut_geometry(geometry, motion.pose);
  const StrutRates<T> rates = strut_rates(commanded, motion, environment);
  const auto loads_at = [&](const Pose<T>& pose, const machine::StrutGeometry<T>& struts) {
    return strut_stretch_at(model, parameters, environment, motion, rates, pose, struts);
  };
  TipError<T> error{motion.pose, {}, loads_at(motion.pose, commanded)};
  const T side = error.loads.jacobian.determinant();
  const auto end = [&](ErrorStop why) {
    error.pose = machine::displaced<T>(error.pose, error.loads.tip);
    error.displacement = machine::displacement_between<T>(motion.pose, error.pose);
    error.stopped_because = why;
    return error;
  };
  if (any(error.loads.jacobian.singular())) return end(ErrorStop::singular);

  for (error.iterations = 1;; ++error.iterations) {
    const machine::PerStrut<T> misfit = commanded.length + error.loads.stretch - error.loads.struts.length;
    const machine::Vector6<T> step = error.loads.jacobian.solve(misfit);
    error.pose = machine::displaced<T>(error.pose, step);
    if (options.first_order) return end(ErrorStop::converged);

    error.loads = loads_at(error.pose, machine::strut_geometry(geometry, error.pose));
    if (any(error.loads.jacobian.singular() || error.loads.jacobian.determinant() * side < T(0.0))) {
      return end(ErrorStop::fell_through);
    }
    error.residual_m = T(0.0);
    for (int a = 0; a < 6; ++a) error.residual_m = larger<T>(error.residual_m, absolute<T>(step[a]));
    if (all(error.residual_m <= T(options.tolerance_m))) return end(ErrorStop::converged);
    if (error.iterations >= options.most_iterations) return end(ErrorStop::too_many_iterations);
  }
}

// Instantiated once, in error.cpp.
extern template TipError<double> tip_error(const ForceModel&, const double*, const Environment&, const Motion<double>&,
                                           const ErrorOptions&);

/// The same with the model's own parameters.
inline TipError<double> tip_error(const ForceModel& model, const Environment& environment, const Motion<double>& motion,
                                  const ErrorOptions& options = {}) {
  return tip_error(model, model.parameters.data(), environment, motion, options);
}

}  // namespace plumbline::physics
