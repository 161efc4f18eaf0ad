// Where it depends on the law of the friction which way it acts.
#pragma once

#include <cstddef>
#include <vector>

#include "machine/model.hpp"
#include "measure/dataset.hpp"
#include "physics/force_model.hpp"

namespace plumbline::measure {

struct FrictionTurnOptions {
  double way = 25e-6;  // m of travel of a strut after it turned round: screws bend for some 10 um before they slip
  double slow = 3;     // v0 of the model, up to which the friction of a strut turns with its speed
  double most_of_run = 0.25;  // of the samples; with more a strut rests nearly all the time
  std::size_t edge = 5;       // samples on either side that say what a model leaves there
};

/// Samples in a row at which a strut turns round on the commanded path: from `turned` on it has.
struct FrictionTurn {
  std::size_t begin = 0;
  std::size_t turned = 0;
  std::size_t end = 0;
};

/// Where struts turn round in a run, in the order of its samples. Friction without memory has turned there, friction
/// with one has not [Armstrong-Helouvry et al. 1994, on pre-sliding]. None where that were too many samples.
std::vector<FrictionTurn> friction_turns(const machine::MachineModel& machine, const physics::ForceModel& forces,
                                         const Run& run, const FrictionTurnOptions& options = {});

/// The run without these samples.
Run without_friction_turns(const machine::MachineModel& machine, const physics::ForceModel& forces, Run run,
                           const FrictionTurnOptions& options = {});

/// Readings there as a machine without memory would have them: what the model leaves goes on as it does beside them. So
/// that what is low-passed has nothing of them beside itself. Refuses with simulate-unreachable as simulate_run does.
void fill_friction_turns(const machine::MachineModel& machine, const physics::ForceModel& forces, Run& run,
                         const FrictionTurnOptions& options = {});

}  // namespace plumbline::measure
