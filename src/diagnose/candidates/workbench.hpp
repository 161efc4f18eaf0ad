// What all steps of a diagnosis need.
#pragma once

#include "diagnose/candidates/candidate_set.hpp"
#include "measure/dataset.hpp"

namespace plumbline::diagnose {

/// Kept by reference.
struct Workbench {
  const machine::MachineModel& machine;
  const physics::ForceModel& forces;  // of the machine as stated
  const std::vector<measure::Run>& runs;
  const CandidateSet& candidates;
};

}  // namespace plumbline::diagnose
