// Which runs are kept out of the fit, to be predicted: whole poses.
#pragma once

#include <vector>

#include "diagnose/candidates/candidate_set.hpp"
#include "measure/dataset.hpp"

namespace plumbline::diagnose {

struct HeldOutOptions {
  int least_poses = 4;  // with fewer, none is held out
  int poses_of = 8;     // one in so many poses
  // noise that is assumed before any is estimated: of a bar and of motors as they are sold
  double usual_radial = 0.5e-6;  // m
  double usual_torque = 0.05;    // N m
};

/// For each run whether it is held out: the poses (centre and tilt alike) whose loss costs the least information about
/// the effects of the candidates, the sum over all columns of -log(1 - share of the column's square).
std::vector<bool> held_out(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                           const CandidateSet& candidates, const HeldOutOptions& options = {});

}  // namespace plumbline::diagnose
