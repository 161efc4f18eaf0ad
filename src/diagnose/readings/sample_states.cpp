#include "diagnose/readings/sample_states.hpp"

namespace plumbline::diagnose {

std::vector<SampleState> sample_states(const machine::RotationOrder& order, const physics::ForceModel& forces,
                                       const measure::Run& run) {
  const physics::Environment environment = measure::environment_of(forces, run);
  std::vector<SampleState> states;
  states.reserve(run.samples());
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const physics::Motion<double> motion = measure::circular_motion(order, run, i);
    const physics::TipError<double> error = physics::tip_error(forces, environment, motion);
    const machine::StrutGeometry<double> commanded = machine::strut_geometry(forces.machine.geometry, motion.pose);
    const physics::StrutRates<double> rates = physics::strut_rates(commanded, motion, environment);
    states.push_back({error.loads.struts, rates.speed, rates.acceleration, rates.sign, error.loads.nut_tension,
                      error.loads.torque, error.pose, motion.time});
  }
  return states;
}

}  // namespace plumbline::diagnose
