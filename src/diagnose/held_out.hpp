// Which runs are kept out of the fit, to be predicted: whole poses.
#pragma once

#include <vector>

#include "diagnose/candidates/candidate_set.hpp"
#include "measure/dataset.hpp"

namespace plumbline::diagnose {

struct HeldOutOptions {
  int least_poses = 4;  // with fewer, none is held out
  int poses_of = 8;     // one in so many poses
};

/// For each run whether it is held out: the poses (centre and tilt alike) whose loss costs the least information about
/// the effects of the candidates, the sum over all columns of -log(1 - share of the column's square).
std::vector<bool> held_out(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                           const CandidateSet& candidates, const HeldOutOptions& options = {});

}  // namespace plumbline::diagnose
