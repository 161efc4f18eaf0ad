#include "compensate/loaded_machine.hpp"

#include "machine/condition.hpp"

namespace plumbline::compensate {

LoadedMachine::LoadedMachine(const machine::MachineModel& model, const Settings& settings)
    : model_(model),
      time_s_(settings.time_s.value_or(0)),
      forces_(model),
      environment_(forces_.environment()),
      radius_(machine::platform_radius(model.geometry)) {
  environment_.friction = settings.friction;
  environment_.dynamic = settings.dynamic;
}

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

physics::StrutStretch<double> LoadedMachine::loads(const physics::Motion<double>& motion) const {
  const machine::StrutGeometry<double> struts = machine::strut_geometry(geometry(), motion.pose);
  const physics::StrutRates<double> rates = physics::strut_rates(struts, motion, environment_);
  return physics::strut_stretch_at(forces_, forces_.parameters.data(), environment_, motion, rates, motion.pose,
                                   struts);
}

double LoadedMachine::condition(const Pose<double>& pose) const {
  return machine::condition_number(machine::strut_geometry(geometry(), pose), radius_);
}

}  // namespace plumbline::compensate
