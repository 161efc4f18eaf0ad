#include "compensate/loaded_machine.hpp"

#include "machine/condition.hpp"
#include "physics/strut_stretch.hpp"

namespace plumbline::compensate {

LoadedMachine::LoadedMachine(const machine::MachineModel& model, const Settings& settings)
    : model_(model),
      time_s_(settings.time_s.value_or(0)),
      forces_(model),
      environment_(environment_of(forces_, settings)),
      radius_(machine::platform_radius(model.geometry)) {}

void LoadedMachine::set_tool(const ToolInSpindle& tool) {
  forces_.machine.geometry = machine::with_tool(model_.geometry, tool.length);
  environment_.tool_mass = tool.mass - model_.reference_tool_mass;
  environment_.tool_centre_P = model_.geometry.tool_tip_P - Vector3<double>(0, 0, tool.along);
}

physics::Motion<double> LoadedMachine::motion(const Target& target) const {
  physics::Motion<double> motion = motion_at(model_.rotation, radius_, target, environment_);
  motion.time = time_s_;
  return motion;
}

// The stages of physics::strut_stretch_at as far as the nuts.
LoadedMachine::Carried LoadedMachine::carried(const physics::Motion<double>& motion) const {
  const double* const parameters = forces_.parameters.data();
  const machine::StrutGeometry<double> struts = machine::strut_geometry(geometry(), motion.pose);
  const physics::StrutRates<double> rates = physics::strut_rates(struts, motion, environment_);
  physics::Situation<double> at{forces_.machine, environment_, motion, rates, motion.pose, struts, {}};
  at.conditions.gravity = forces_.machine.gravity;
  physics::ask_conditions(forces_, parameters, at, at.conditions);
  machine::StrutVectors<double> transverse = machine::StrutVectors<double>::Zero();
  const physics::Wrench<double> wrench = physics::wrench_from_conditions(forces_, parameters, at, transverse);
  machine::Vector6<double> load;
  load << wrench.force, wrench.moment;
  const machine::Lu6<double> lu(machine::jacobian(struts));
  physics::nut_from_joint_tension<double>(forces_, parameters, at, lu.solve_transposed(load));
  return {struts.length, at.nut_tension, lu.singular()};
}

void LoadedMachine::carry(exact::PoseBatch& batch) const {
  exact::Setup setup;
  setup.environment = environment_;
  setup.rotation = model_.rotation;
  setup.radius = radius_;
  setup.time = time_s_;
  setup.take_geometry(forces_, machine::home_pose(model_));
  batch.carry(setup, exact::Friction::as_modelled);
}

double LoadedMachine::condition(const Pose<double>& pose) const {
  return machine::condition_number(machine::strut_geometry(geometry(), pose), radius_);
}

}  // namespace plumbline::compensate
