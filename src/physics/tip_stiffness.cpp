#include "physics/tip_stiffness.hpp"

#include <limits>

#include <Eigen/SVD>

namespace plumbline::physics {
namespace {

// Where the tip goes with these tensions of the platform joints: m, without the part that all tensions share.
Vector3<double> tip_with(const ForceModel& model, Situation<double>& at, const machine::Lu6<double>& jacobian,
                         const machine::PerStrut<double>& tension) {
  const double* const parameters = model.parameters.data();
  nut_from_joint_tension(model, parameters, at, tension);
  drive_from_nut_tension(model, parameters, at);
  const machine::PerStrut<double> stretch = stretch_from_drive_tension(model, parameters, at);
  const machine::Vector6<double> tip = jacobian.solve(stretch) + tip_from_drive_tension(model, parameters, at);
  return tip.head<3>();
}

}  // namespace

Matrix3<double> tip_compliance(const ForceModel& model, const Environment& environment, const Motion<double>& motion,
                               const TipError<double>& error, const TipStiffnessOptions& options) {
  const machine::StrutGeometry<double> commanded = machine::strut_geometry(model.machine.geometry, motion.pose);
  const StrutRates<double> rates = strut_rates(commanded, motion, environment);
  Situation<double> at{model.machine, environment, motion, rates, error.pose, error.loads.struts, {}};
  at.conditions.gravity = model.machine.gravity;
  ask_conditions(model, model.parameters.data(), at, at.conditions);
  Matrix3<double> compliance;
  for (int axis = 0; axis < 3; ++axis) {
    // J^T t = (N, M): a force at the tip has no moment about it
    const machine::Vector6<double> push = options.force * machine::Vector6<double>::Unit(axis);
    const machine::PerStrut<double> more = error.loads.jacobian.solve_transposed(push);
    const Vector3<double> forth = tip_with(model, at, error.loads.jacobian, error.loads.tension + more);
    const Vector3<double> back = tip_with(model, at, error.loads.jacobian, error.loads.tension - more);
    compliance.col(axis) = (forth - back) / (2 * options.force);
  }
  return compliance;
}

double least_stiffness(const Matrix3<double>& compliance) {
  const double most = compliance.jacobiSvd().singularValues()[0];
  return most > 0 ? 1 / most : std::numeric_limits<double>::infinity();
}

}  // namespace plumbline::physics
