// What the machine does at each sample of a run: what effects may depend on.
#pragma once

#include <vector>

#include "measure/simulation.hpp"

namespace plumbline::diagnose {

/// One sample as the model has it, SI.
struct SampleState {
  machine::StrutGeometry<double> struts;   // where the machine stands
  machine::PerStrut<double> speed;         // Ldot_j
  machine::PerStrut<double> acceleration;  // Lddot_j
  machine::PerStrut<double> sign;          // s_j
  machine::PerStrut<double> nut_tension;   // t_nut,j
  machine::PerStrut<double> torque;        // as read
  Pose<double> pose;                       // where the machine stands
  double time = 0;                         // on the clock of the dataset
};

/// All samples of a run. The machine is taken to reach them: identify::simulate_run refuses what it does not.
std::vector<SampleState> sample_states(const machine::RotationOrder& order, const physics::ForceModel& forces,
                                       const measure::Run& run);

}  // namespace plumbline::diagnose
