// A circular test that is to be made: its design without readings, and whether the machine can make it.
#pragma once

#include "machine/model.hpp"
#include "measure/dataset.hpp"

namespace plumbline::measure {

/// Gives a run so many samples, evenly spaced over the turn, and readings of zero where it has a bar and torques.
void lay_samples(Run& run, std::size_t samples, bool bar, bool torques);

/// Whether the machine keeps its limits of tilt, travel and struts at every sample of a run.
bool within_limits(const machine::MachineModel& machine, const Run& run);

}  // namespace plumbline::measure
