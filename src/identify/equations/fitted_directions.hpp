// What a fit took of the noise of one channel: the directions of the unknowns that its readings tell.
#pragma once

#include <vector>

#include "identify/equations/noise.hpp"

namespace plumbline::identify {

/// Changes of the unknowns that one channel of the readings tells, independent of each other, in standard deviations
/// of what all readings and priors leave open.
struct FittedDirections {
  Eigen::MatrixXd changes;  // unknowns x directions, SI: slopes times this are readings per direction
  Eigen::VectorXd share;    // of what is known of each direction, 0 to 1: the part that this channel tells
  double degrees = 0;       // degrees of freedom that the fit took from this channel: the sum of all shares
};

/// The directions whose share is more than `least_share`, under the noise that `fitted` names; none of a channel that
/// was not measured. `runs` need their slopes.
FittedDirections fitted_directions(const std::vector<RunEquations>& runs, int channel, const FittedUnknowns& fitted,
                                   double least_share = NoiseOptions().least_share);

}  // namespace plumbline::identify
