#include "measure/planned_run.hpp"

#include "base/angle.hpp"
#include "machine/limits.hpp"
#include "measure/circular_motion.hpp"

namespace plumbline::measure {

void lay_samples(Run& run, std::size_t samples, bool bar, bool torques) {
  run.time.clear();
  run.angle.clear();
  for (std::size_t i = 0; i < samples; ++i) {
    const double turn = kTurn * static_cast<double>(i) / static_cast<double>(samples);
    run.time.push_back(turn * run.radius / run.feed);
    run.angle.push_back(run.turn() * turn);
  }
  run.radial.assign(bar ? samples : 0, 0);
  for (auto& torque : run.torque) torque.assign(torques ? samples : 0, 0);
}

bool within_limits(const machine::MachineModel& machine, const Run& run) {
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const Pose<double> pose = circular_motion(machine.rotation, run, i).pose;
    if (!machine::check_programmed(machine.limits, pose).empty()) return false;
    if (!machine::check_compensated(machine.limits, machine.geometry, pose).empty()) return false;
  }
  return true;
}

}  // namespace plumbline::measure
