// Which effects a set of circular tests could name, before anything is measured.
#pragma once

#include <vector>

#include "diagnose/evidence/visible.hpp"
#include "identify/equations/noise.hpp"
#include "measure/dataset.hpp"

namespace plumbline::jobs {

struct CouldNameOptions {
  std::size_t samples = 36;  // of each run that are looked at; they stand for all
  int draws = 4000;          // for the threshold
};

/// For each effect of the catalogue the smallest size that a diagnosis of these runs would name with 95 %, the machine
/// being as its model says. `noise` is that of a reading, independent from sample to sample. What runs read counts, not
/// their readings. Refuses with simulate-unreachable.
std::vector<diagnose::Visible> could_name(const machine::MachineModel& machine, std::vector<measure::Run> runs,
                                          const identify::NoiseModel& noise, const CouldNameOptions& options = {});

}  // namespace plumbline::jobs
